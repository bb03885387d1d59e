// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "proofmass/core/progress.hpp"

namespace proofmass::cli {

// Progress on standard error, from two seconds on: one line rewritten in place on a terminal, a line every
// ten seconds elsewhere, nothing when quiet. A step that says nothing for that long is shown with the time
// that it has taken. Cancelled by SIGINT and SIGTERM, see InterruptGuard.
class ConsoleProgress final : public Progress {
 public:
  explicit ConsoleProgress(bool quiet);
  ~ConsoleProgress() override;
  ConsoleProgress(const ConsoleProgress&) = delete;
  ConsoleProgress& operator=(const ConsoleProgress&) = delete;
  void update(std::string_view stage, std::size_t done, std::size_t total) override;
  [[nodiscard]] bool cancelled() const noexcept override;
  // Takes the line off the terminal, for results to follow, and shows nothing more until the next update.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  [[nodiscard]] bool is_due(Clock::time_point now) const;
  void show(Clock::time_point now);
  void watch();  // until stop_, in a thread of its own

  bool quiet_;
  bool rewrite_;  // standard error is a terminal
  bool shown_ = false;
  std::string stage_;  // empty: nothing is under way
  std::size_t done_ = 0;
  std::size_t total_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point stage_start_ = start_;
  std::size_t stage_first_ = 0;  // units done when the stage was first heard of
  Clock::time_point last_ = start_;
  std::mutex mutex_;
  std::condition_variable woken_;
  bool stop_ = false;
  std::thread watcher_;
};

}  // namespace proofmass::cli
