// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/ending.hpp"

#include <algorithm>
#include <array>

namespace proofmass {
namespace {

// In the order of EndingCode.
constexpr auto kEndingCodes = static_cast<std::size_t>(EndingCode::units_in_vain) + 1;
constexpr std::array<std::string_view, kEndingCodes> kEndingNames{"verbatim",
                                                                  "start_not_finite",
                                                                  "stopped_by_observer",
                                                                  "stopped_on_request",
                                                                  "distance_iterations_spent",
                                                                  "distance_step_short",
                                                                  "distance_stands_still",
                                                                  "distance_no_step",
                                                                  "distance_runs_away",
                                                                  "distance_other_start",
                                                                  "distance_local_minimum",
                                                                  "reweighting_converged",
                                                                  "reweighting_spent",
                                                                  "variance_converged",
                                                                  "variance_spent",
                                                                  "swarm_at_target",
                                                                  "swarm_stalled",
                                                                  "swarm_spent",
                                                                  "descent_at_target",
                                                                  "descent_stalled",
                                                                  "descent_no_step",
                                                                  "descent_polished",
                                                                  "epochs_spent",
                                                                  "gradient_small",
                                                                  "residuals_orthogonal",
                                                                  "weights_perturbed",
                                                                  "validation_stalled",
                                                                  "layers_stalled",
                                                                  "layers_spent",
                                                                  "layers_without_pair",
                                                                  "normal_equations",
                                                                  "weighted_normal_equations",
                                                                  "singular_values",
                                                                  "after_iterations",
                                                                  "subsets_searched",
                                                                  "subsets_proven",
                                                                  "subsets_not_proven",
                                                                  "fish_swarm",
                                                                  "evaluations",
                                                                  "particle_swarm",
                                                                  "training",
                                                                  "nothing_left",
                                                                  "best_candidate",
                                                                  "sizes_compared",
                                                                  "sizes_compared_to_limit",
                                                                  "size_compared",
                                                                  "network_kept",
                                                                  "network_dropped",
                                                                  "network_not_judged",
                                                                  "sizes_unfinished",
                                                                  "units_suffice",
                                                                  "units_added",
                                                                  "units_in_vain"};
static_assert(!kEndingNames.back().empty(), "a name for each code");

}  // namespace

std::string_view to_string(EndingCode code) noexcept { return kEndingNames[static_cast<std::size_t>(code)]; }

std::optional<EndingCode> find_ending_code(std::string_view name) noexcept {
  const auto* const found = std::find(kEndingNames.begin(), kEndingNames.end(), name);
  if (found == kEndingNames.end()) return std::nullopt;
  return static_cast<EndingCode>(found - kEndingNames.begin());
}

std::vector<EndingCode> all_ending_codes() {
  std::vector<EndingCode> codes;
  for (std::size_t k = 0; k < kEndingCodes; ++k) codes.push_back(static_cast<EndingCode>(k));
  return codes;
}

bool mentions(const std::vector<EndingPart>& parts, EndingCode code) noexcept {
  return std::any_of(parts.begin(), parts.end(), [code](const EndingPart& part) {
    return part.code == code || mentions(part.parts, code);
  });
}

}  // namespace proofmass
