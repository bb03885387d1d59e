// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/model/ending_of.hpp"

#include <utility>

namespace proofmass {
namespace {

EndingCode code_of(Event event) noexcept {
  switch (event) {
    case Event::start_not_finite:
      return EndingCode::start_not_finite;
    case Event::stopped_by_observer:
      return EndingCode::stopped_by_observer;
    case Event::stopped_on_request:
      return EndingCode::stopped_on_request;
    case Event::distance_iterations_spent:
      return EndingCode::distance_iterations_spent;
    case Event::distance_step_short:
      return EndingCode::distance_step_short;
    case Event::distance_stands_still:
      return EndingCode::distance_stands_still;
    case Event::distance_no_step:
      return EndingCode::distance_no_step;
    case Event::distance_runs_away:
      return EndingCode::distance_runs_away;
    case Event::distance_other_start:
      return EndingCode::distance_other_start;
    case Event::distance_local_minimum:
      return EndingCode::distance_local_minimum;
    case Event::reweighting_converged:
      return EndingCode::reweighting_converged;
    case Event::reweighting_spent:
      return EndingCode::reweighting_spent;
    case Event::variance_converged:
      return EndingCode::variance_converged;
    case Event::variance_spent:
      return EndingCode::variance_spent;
    case Event::swarm_at_target:
      return EndingCode::swarm_at_target;
    case Event::swarm_stalled:
      return EndingCode::swarm_stalled;
    case Event::swarm_spent:
      return EndingCode::swarm_spent;
    case Event::descent_at_target:
      return EndingCode::descent_at_target;
    case Event::descent_stalled:
      return EndingCode::descent_stalled;
    case Event::descent_no_step:
      return EndingCode::descent_no_step;
    case Event::descent_polished:
      return EndingCode::descent_polished;
    case Event::epochs_spent:
      return EndingCode::epochs_spent;
    case Event::gradient_small:
      return EndingCode::gradient_small;
    case Event::residuals_orthogonal:
      return EndingCode::residuals_orthogonal;
    case Event::weights_perturbed:
      return EndingCode::weights_perturbed;
    case Event::validation_stalled:
      return EndingCode::validation_stalled;
    case Event::layers_stalled:
      return EndingCode::layers_stalled;
    case Event::layers_spent:
      return EndingCode::layers_spent;
    case Event::layers_without_pair:
      return EndingCode::layers_without_pair;
  }
  return EndingCode::verbatim;
}

}  // namespace

EndingStatus ending_status(Cause cause) noexcept {
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

std::vector<EndingPart> ending_parts(const Termination& termination) {
  std::vector<EndingPart> parts;
  for (const Remark& remark : termination.remarks) {
    EndingPart part{.code = code_of(remark.event)};
    for (const NamedNumber& figure : remark.figures) part.figures.emplace_back(figure.name, figure.value);
    parts.push_back(std::move(part));
  }
  return parts;
}

Ending ending_of(const Termination& termination) {
  return {.status = ending_status(termination.cause), .parts = ending_parts(termination)};
}

}  // namespace proofmass
