// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/ending.hpp"
#include "proofmass/numeric/optimise/termination.hpp"

namespace proofmass {

// How an identification ended whose iteration ended for this cause.
[[nodiscard]] constexpr EndingStatus ending_status(Cause cause) noexcept {
  switch (cause) {
    case Cause::converged:
      return EndingStatus::converged;
    case Cause::target_reached:
      return EndingStatus::target_reached;
    case Cause::stalled:
      return EndingStatus::stalled;
    case Cause::iteration_limit:
      return EndingStatus::iteration_limit;
    case Cause::stopped:
      return EndingStatus::early_stopped;
  }
  return EndingStatus::failed;
}

}  // namespace proofmass
