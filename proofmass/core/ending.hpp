// SPDX-License-Identifier: Apache-2.0
// How a computation ended, as data: the words are in report/text, in the reader's language.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "proofmass/core/finding.hpp"

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

// What was seen when it ended. Each has a name in snake case, which is its value in JSON, and words in
// report/text.
enum class EndingCode : std::uint8_t {
  verbatim,  // the words of another version's result, in the figure "text"
  // Any iteration.
  start_not_finite,
  stopped_by_observer,
  stopped_on_request,
  // Orthogonal distances.
  distance_iterations_spent,
  distance_step_short,
  distance_stands_still,
  distance_no_step,
  distance_runs_away,
  distance_other_start,
  distance_local_minimum,
  // Weights found from residuals.
  reweighting_converged,
  reweighting_spent,
  variance_converged,
  variance_spent,
  // Swarms.
  swarm_at_target,
  swarm_stalled,
  swarm_spent,
  // Descent, of networks.
  descent_at_target,
  descent_stalled,
  descent_no_step,
  descent_polished,
  epochs_spent,
  gradient_small,
  residuals_orthogonal,
  weights_perturbed,
  validation_stalled,
  // Layers of polynomials.
  layers_stalled,
  layers_spent,
  layers_without_pair,
  // Methods: of some, the parts say more.
  normal_equations,
  weighted_normal_equations,
  singular_values,
  after_iterations,
  subsets_searched,
  subsets_proven,
  subsets_not_proven,
  fish_swarm,
  evaluations,
  particle_swarm,
  training,
  nothing_left,
  best_candidate,
  sizes_compared,
  sizes_compared_to_limit,
  size_compared,
  network_kept,
  network_dropped,
  network_not_judged,
  sizes_unfinished,
  units_suffice,
  units_added,
  units_in_vain,
};
[[nodiscard]] std::string_view to_string(EndingCode code) noexcept;
[[nodiscard]] std::optional<EndingCode> find_ending_code(std::string_view name) noexcept;
// All of them, in order.
[[nodiscard]] std::vector<EndingCode> all_ending_codes();

// Part of the account of an ending, with the figures that the decision used.
struct EndingPart {
  EndingCode code = EndingCode::verbatim;
  std::vector<Figure> figures{};
  std::vector<EndingPart> parts{};  // that its words go round
  friend bool operator==(const EndingPart&, const EndingPart&) = default;
};

struct Ending {
  EndingStatus status = EndingStatus::direct;
  std::vector<EndingPart> parts{};  // one sentence together
  friend bool operator==(const Ending&, const Ending&) = default;
};

// Whether one of the parts, or of those within, says that.
[[nodiscard]] bool mentions(const std::vector<EndingPart>& parts, EndingCode code) noexcept;

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
