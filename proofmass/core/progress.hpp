// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace proofmass {

// Through this interface a long computation reports its progress, and the caller stops it. Only one thread
// calls at a time.
class Progress {
 public:
  Progress() = default;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  virtual ~Progress() = default;
  // `done` of `total` units of work of `stage` are complete.
  virtual void update(std::string_view stage, std::size_t done, std::size_t total) = 0;
  // True when the computation should stop; it then throws an Error of kind interrupted. Any thread may ask.
  [[nodiscard]] virtual bool cancelled() const noexcept = 0;
};

// Reports nothing and never stops.
class SilentProgress final : public Progress {
 public:
  void update(std::string_view, std::size_t, std::size_t) override {}
  [[nodiscard]] bool cancelled() const noexcept override { return false; }
};

}  // namespace proofmass
