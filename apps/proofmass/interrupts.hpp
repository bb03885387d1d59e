// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <csignal>
#include <string>

#include "proofmass/core/error.hpp"

namespace proofmass::cli {

// From here on SIGINT, SIGTERM and SIGHUP end the process with the contract's exit code and a word to
// standard error, whatever it is waiting for. For as long as nothing has been written, nothing need be
// undone.
void leave_when_interrupted(const std::string& word);

// While it lives, those signals ask the work to stop instead, so that it can clean up; a second one ends the
// process.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  std::array<struct sigaction, 3> previous_{};
};

[[nodiscard]] bool interrupted() noexcept;

[[nodiscard]] Error interruption();

// Throws it when asked to stop.
void stop_if_interrupted();

}  // namespace proofmass::cli
