// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "proofmass/core/ending.hpp"
#include "proofmass/numeric/optimise/termination.hpp"

namespace proofmass {

// How an identification ended whose iteration ended so; numeric and core have no words in common but here.
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

[[nodiscard]] inline Ending ending_of(Termination termination) {
  return {.status = ending_status(termination.cause), .reason = std::move(termination.reason)};
}

// With a reason that says more.
[[nodiscard]] inline Ending ending_of(Cause cause, std::string reason) {
  return {.status = ending_status(cause), .reason = std::move(reason)};
}

}  // namespace proofmass
