// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <csignal>

namespace proofmass::cli {

// While it lives, SIGINT, SIGTERM and SIGHUP ask the work to stop instead of ending the process; a second
// signal ends it.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> previous_{};
};

[[nodiscard]] bool interrupted() noexcept;

// Throws an Error of kind interrupted when asked to stop.
void stop_if_interrupted();

}  // namespace proofmass::cli
