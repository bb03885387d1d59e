// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "proofmass/numeric/optimise/termination.hpp"

namespace proofmass {

struct FishSettings {
  std::size_t iterations = 400;
  std::size_t tries = 10;     // points that a preying fish looks at before it swims at random
  double visual = 1.0;        // how far a fish sees; in the unit of the positions, as all lengths
  double step = 0.5;          // the longest stroke
  double crowd_factor = 0.6;  // a place with more than this share of the school within sight is crowded
  // The improved form: visual and step shrink by exp(-decay_rate * (t / iterations)^decay_exponent).
  bool decay = true;
  double decay_rate = 25.0;
  double decay_exponent = 1.0;
  std::size_t stall_iterations = 0;  // ends after so many iterations without a better best; 0: never
  std::optional<double> target;      // ends when the best value is at or below this
};

// Value of a position, to be minimised; not-a-number counts as plus infinity. Called from several threads at
// once, and must depend on the position alone.
using FishObjective = std::function<double(std::span<const double>)>;

// Called after each iteration with the best value so far; returns false to stop.
using FishObserver = std::function<bool(std::size_t iteration, double best)>;

struct FishResult {
  std::vector<double> best;          // the bulletin: the best position that any fish has seen
  double value = 0.0;                // there
  std::vector<double> history;       // bulletin's value of the initial school and after each iteration
  std::vector<double> mean_history;  // mean value where the fish are, finite ones only
  std::size_t evaluations = 0;
  Termination termination;
};

// Artificial fish swarm (Li, Shao & Qian 2002) from the initial positions given. In each iteration every fish
// tries to swarm (towards the centre of the fish in sight) and to follow (towards the best of them), each
// only if the place is better than its own and not crowded, and preys otherwise; it goes where the better of
// the two led. All fish move at once, from what they saw before; every fish draws from a stream of its own,
// so the result does not depend on the number of threads. Values are only compared, never added or
// multiplied: the course is the same for every increasing function of the objective. Throws
// std::invalid_argument when there are no fish, they differ in length, or a length, share or rate makes no
// sense.
[[nodiscard]] FishResult minimise_by_fish(const FishObjective& objective,
                                          std::vector<std::vector<double>> initial,
                                          const FishSettings& settings, std::uint64_t seed,
                                          const FishObserver& observer = {});

}  // namespace proofmass
