// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <mutex>
#include <string_view>

#include "proofmass/core/error.hpp"
#include "proofmass/core/progress.hpp"

namespace proofmass {

// Counts the steps of a longer computation under one name. Progress reported inside a step is not passed on.
// Steps may end on any thread.
class StepProgress final : public Progress {
 public:
  // Keeps a reference to the name, which must outlive this object.
  StepProgress(Progress& outer, std::string_view stage, std::size_t total)
      : outer_(outer), stage_(stage), total_(total) {
    outer_.update(stage_, 0, total_);
  }
  void update(std::string_view, std::size_t, std::size_t) override {}
  [[nodiscard]] bool cancelled() const noexcept override { return outer_.cancelled(); }
  // Throws an Error of kind interrupted when the computation should stop.
  void require_going() const {
    if (cancelled()) throw Error(ErrorKind::interrupted, "interrupted");
  }
  // Reports the end of one step. Throws as require_going.
  void step() {
    require_going();
    const std::lock_guard lock(reporting_);
    outer_.update(stage_, ++done_, total_);
  }

 private:
  Progress& outer_;
  std::string_view stage_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::mutex reporting_;
};

}  // namespace proofmass
