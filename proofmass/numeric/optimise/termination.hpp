// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace proofmass {

// Why an iteration ended.
enum class Cause {
  converged,        // a condition of optimality holds
  target_reached,   // the value asked for is reached
  stalled,          // no progress worth its cost
  iteration_limit,  // the iterations allowed are spent
  stopped,          // the observer asked to stop
};

struct Termination {
  Cause cause = Cause::iteration_limit;
  std::string reason;  // one sentence with the figures that decided it
};

}  // namespace proofmass
