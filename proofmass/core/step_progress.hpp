// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <mutex>
#include <string_view>

#include "proofmass/core/error.hpp"
#include "proofmass/core/progress.hpp"

namespace proofmass {

// Counts the steps of a longer work under one name; what is reported inside a step is kept back. Steps may
// end on any thread.
class StepProgress final : public Progress {
 public:
  // Keeps the name, which must outlive it.
  StepProgress(Progress& outer, std::string_view stage, std::size_t total)
      : outer_(outer), stage_(stage), total_(total) {
    outer_.update(stage_, 0, total_);
  }
  void update(std::string_view, std::size_t, std::size_t) override {}
  [[nodiscard]] bool cancelled() const noexcept override { return outer_.cancelled(); }
  // Throws an Error of kind interrupted when the work should stop.
  void require_going() const {
    if (cancelled()) throw Error(ErrorKind::interrupted, "interrupted");
  }
  // One step has ended. Throws as require_going.
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
