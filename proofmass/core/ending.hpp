// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace proofmass {

// How a computation ended. `direct` is for methods without iteration.
enum class EndingStatus {
  direct,
  converged,
  target_reached,
  stalled,
  early_stopped,
  iteration_limit,
  failed
};

struct Ending {
  EndingStatus status = EndingStatus::direct;
  std::string reason;  // one sentence, with the figures that the decision used
};

[[nodiscard]] constexpr std::string_view to_string(EndingStatus status) noexcept {
  switch (status) {
    case EndingStatus::direct:
      return "direct";
    case EndingStatus::converged:
      return "converged";
    case EndingStatus::target_reached:
      return "target_reached";
    case EndingStatus::stalled:
      return "stalled";
    case EndingStatus::early_stopped:
      return "early_stopped";
    case EndingStatus::iteration_limit:
      return "iteration_limit";
    case EndingStatus::failed:
      return "failed";
  }
  return "failed";
}

}  // namespace proofmass
