// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace proofmass {

// Why an iteration ended.
enum class Cause {
  converged,        // a condition of optimality holds
  target_reached,   // the value asked for is reached
  stalled,          // no further progress, or too little
  iteration_limit,  // all allowed iterations have been used
  stopped,          // the observer asked to stop
};

struct Termination {
  Cause cause = Cause::iteration_limit;
  std::string reason;  // one sentence, with the figures that the decision used
};

}  // namespace proofmass
