// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace proofmass {

// Why an iteration ended.
enum class Cause {
  converged,        // a condition of optimality holds
  target_reached,   // the value asked for is reached
  stalled,          // no further progress, or too little
  iteration_limit,  // all allowed iterations have been used
  stopped,          // the observer asked to stop
};

// What was seen when it ended. The words are for others to find.
enum class Event {
  start_not_finite,  // the value at the start
  stopped_by_observer,
  stopped_on_request,
  distance_iterations_spent,  // iterations, length of the last step
  distance_step_short,        // length, limit
  distance_stands_still,      // sum of squares, length of the step that remains, reduction by it
  distance_no_step,           // sum, damping
  distance_runs_away,         // sum, significance of the parameters
  distance_other_start,       // start that gave the best result, of a total
  distance_local_minimum,     // sum, lower sum beyond
  reweighting_converged,      // count, last step
  reweighting_spent,          // count, last step
  variance_converged,         // count, fraction, last step
  variance_spent,             // count, fraction, last step
  swarm_at_target,            // value, target
  swarm_stalled,              // iterations
  swarm_spent,                // iterations
  descent_at_target,          // sum, target
  descent_stalled,            // reduction, epochs
  descent_no_step,            // damping
  descent_polished,           // steps
  epochs_spent,
  gradient_small,        // gradient, limit
  residuals_orthogonal,  // limit of the cosines
  weights_perturbed,     // count, idle ones
  validation_stalled,    // epochs
  layers_stalled,        // layer, value before, value after, percent asked for
  layers_spent,          // layers
  layers_without_pair,   // layer
};

struct NamedNumber {
  NamedNumber(std::string_view number, double is) : name(number), value(is) {}
  NamedNumber(std::string_view number, std::size_t is) : name(number), value(static_cast<double>(is)) {}
  std::string_view name;  // of static storage
  double value;
};

struct Remark {
  Event event = Event::start_not_finite;
  std::vector<NamedNumber> figures{};  // that the decision used
};

struct Termination {
  Cause cause = Cause::iteration_limit;
  std::vector<Remark> remarks{};
};

[[nodiscard]] inline Termination ended(Cause cause, Event event, std::vector<NamedNumber> figures = {}) {
  return {.cause = cause, .remarks = {{.event = event, .figures = std::move(figures)}}};
}

}  // namespace proofmass
