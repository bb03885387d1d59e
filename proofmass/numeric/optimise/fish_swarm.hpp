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
  std::size_t tries = 10;     // points that a preying fish looks at before it moves at random
  double visual = 1.0;        // how far a fish sees; all lengths are in the unit of the positions
  double step = 0.5;          // the longest move
  double crowd_factor = 0.6;  // a place with more than this fraction of the school in sight is crowded
  // The improved form: visual and step shrink by exp(-decay_rate * (t / iterations)^decay_exponent).
  bool decay = true;
  double decay_rate = 25.0;
  double decay_exponent = 1.0;
  std::size_t stall_iterations = 0;  // ends after this many iterations without a better best; 0: never
  std::optional<double> target;      // ends when the best value is at or below this
};

// Value of a position, to be minimised. NaN counts as plus infinity. It is called from several threads at
// once, and must depend only on the position.
using FishObjective = std::function<double(std::span<const double>)>;

// Called after each iteration with the best value so far; returns false to stop.
using FishObserver = std::function<bool(std::size_t iteration, double best)>;

struct FishResult {
  std::vector<double> best;          // the bulletin: the best position that any fish has seen
  double value = 0.0;                // its value
  std::vector<double> history;       // value of the bulletin for the initial school and after each iteration
  std::vector<double> mean_history;  // mean value at the positions of the fish, finite values only
  std::size_t evaluations = 0;
  Termination termination;
};

// Artificial fish swarm (Li, Shao & Qian 2002) from the given initial positions. In each iteration every fish
// tries to swarm (towards the centre of the fish in sight) and to follow (towards the best of them). Either
// is done only if the place is better than its own and not crowded; otherwise the fish preys. It takes the
// better of the two results. All fish move at once, from the positions before the iteration. Every fish draws
// from its own random stream, so the result does not depend on the number of threads. Values are only
// compared, never added or multiplied, so every increasing function of the objective gives the same search.
// Throws std::invalid_argument when there are no fish, they differ in length, or a length, fraction or rate
// is not valid.
[[nodiscard]] FishResult minimise_by_fish(const FishObjective& objective,
                                          std::vector<std::vector<double>> initial,
                                          const FishSettings& settings, std::uint64_t seed,
                                          const FishObserver& observer = {});

}  // namespace proofmass
