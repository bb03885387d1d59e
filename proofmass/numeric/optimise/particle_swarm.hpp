// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "proofmass/numeric/optimise/termination.hpp"

namespace proofmass {

enum class SwarmUpdate {
  synchronous,   // all particles move, then all bests are renewed: evaluations run in parallel
  asynchronous,  // each particle's best counts at once for those that move after it: one thread
};
enum class SwarmTopology {
  global,
  ring,
  von_neumann
};  // whose bests a particle sees: all, its 2 or its 4 neighbours
enum class SwarmWalls { none, absorb, reflect };  // what the box does to a particle that would leave it

struct SwarmSettings {
  std::size_t iterations = 60;
  double inertia = 0.7298;  // constriction coefficients of Clerc & Kennedy 2002
  double cognitive = 1.49618;
  double social = 1.49618;
  SwarmUpdate update = SwarmUpdate::synchronous;
  SwarmTopology topology = SwarmTopology::ring;
  SwarmWalls walls = SwarmWalls::none;
  double lower = -1.0;  // the box, the same in every dimension; walls and velocity limit refer to it
  double upper = 1.0;
  double velocity_limit = 0.0;       // share of the box's width, a dimension a step; 0: no limit
  std::size_t stall_iterations = 0;  // ends after so many iterations without a better best; 0: never
  std::optional<double> target = std::nullopt;  // ends when the best value is at or below this
};

// Value of a position, to be minimised; not-a-number counts as plus infinity. Called from several threads at
// once when the update is synchronous, and must depend on the position alone.
using SwarmObjective = std::function<double(std::span<const double>)>;

// Called after each iteration with the best value so far; returns false to stop.
using SwarmObserver = std::function<bool(std::size_t iteration, double best)>;

struct SwarmResult {
  std::vector<std::vector<double>> positions;  // each particle's own best
  std::vector<double> values;                  // there
  std::size_t best = 0;              // the particle with the least value; the lowest number among equals
  std::vector<double> history;       // best value of the initial swarm and after each iteration
  std::vector<double> mean_history;  // mean over the particles of their own best values, finite ones only
  std::size_t evaluations = 0;
  Termination termination;
};

// Particle swarm optimisation (Kennedy & Eberhart 1995, with the inertia weight of Shi & Eberhart 1998) from
// the initial positions given, at rest. Every particle draws from a stream of its own, so the result does not
// depend on the number of threads. Throws std::invalid_argument when there are no particles or they differ in
// length.
[[nodiscard]] SwarmResult minimise_by_swarm(const SwarmObjective& objective,
                                            std::vector<std::vector<double>> initial,
                                            const SwarmSettings& settings, std::uint64_t seed,
                                            const SwarmObserver& observer = {});

// The particles that particle i of n sees besides itself.
[[nodiscard]] std::vector<std::size_t> swarm_neighbours(SwarmTopology topology, std::size_t i, std::size_t n);

}  // namespace proofmass
