// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

namespace proofmass::cli {

// While it lives, SIGINT and SIGTERM ask the work to stop instead of ending the process; a second signal ends
// it.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  struct sigaction previous_int_ {};
  struct sigaction previous_term_ {};
};

[[nodiscard]] bool interrupted() noexcept;

// Throws an Error of kind interrupted when asked to stop.
void stop_if_interrupted();

}  // namespace proofmass::cli
