// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <string>

#include "proofmass/core/progress.hpp"

namespace proofmass::cli {

// Progress on standard error, from two seconds on: one line rewritten in place on a terminal, a line every
// ten seconds elsewhere, nothing when quiet. Cancelled by SIGINT and SIGTERM, see InterruptGuard.
class ConsoleProgress final : public Progress {
 public:
  explicit ConsoleProgress(bool quiet);
  ~ConsoleProgress() override;
  void update(std::string_view stage, std::size_t done, std::size_t total) override;
  [[nodiscard]] bool cancelled() const noexcept override;
  // Takes the line off the terminal, for results to follow.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] bool is_due(Clock::time_point now) const;
  bool quiet_;
  bool rewrite_;  // standard error is a terminal
  bool shown_ = false;
  std::string stage_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point stage_start_ = start_;
  std::size_t stage_first_ = 0;  // units done when the stage was first heard of
  Clock::time_point last_ = start_;
};

// "pso-bp swarm: 12 of 60 (20 %), 1:05 left"; the time left is unknown until something is done.
[[nodiscard]] std::string progress_text(std::string_view stage, std::size_t done, std::size_t total,
                                        double seconds_left);

}  // namespace proofmass::cli
