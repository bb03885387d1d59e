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
  synchronous,   // all particles move, then all bests are updated: evaluations run in parallel
  asynchronous,  // a particle's best is used at once by the particles that move after it: one thread
};
enum class SwarmTopology {
  global,
  ring,
  von_neumann
};  // whose bests a particle sees: all, its 2 or its 4 neighbours
enum class SwarmWalls { none, absorb, reflect };  // what happens to a particle that would leave the box

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
  double velocity_limit = 0.0;  // largest step per dimension as a fraction of the box's width; 0: no limit
  std::size_t stall_iterations = 0;  // ends after this many iterations without a better best; 0: never
  std::optional<double> target = std::nullopt;  // ends when the best value is at or below this
};

// Value of a position, to be minimised. NaN counts as plus infinity. It is called from several threads at
// once when the update is synchronous, and must depend only on the position.
using SwarmObjective = std::function<double(std::span<const double>)>;

// Called after each iteration with the best value so far; returns false to stop.
using SwarmObserver = std::function<bool(std::size_t iteration, double best)>;

struct SwarmResult {
  std::vector<std::vector<double>> positions;  // each particle's own best
  std::vector<double> values;                  // their values
  std::size_t best = 0;              // the particle with the least value; the lowest number among equals
  std::vector<double> history;       // best value of the initial swarm and after each iteration
  std::vector<double> mean_history;  // mean over the particles of their own best values, finite ones only
  std::size_t evaluations = 0;
  Termination termination;
};

// Particle swarm optimisation (Kennedy & Eberhart 1995, with the inertia weight of Shi & Eberhart 1998) from
// the given initial positions, at rest. Every particle draws from its own random stream, so the result does
// not depend on the number of threads. Throws std::invalid_argument when there are no particles or they
// differ in length.
[[nodiscard]] SwarmResult minimise_by_swarm(const SwarmObjective& objective,
                                            std::vector<std::vector<double>> initial,
                                            const SwarmSettings& settings, std::uint64_t seed,
                                            const SwarmObserver& observer = {});

// The neighbours of particle i of n, without itself.
[[nodiscard]] std::vector<std::size_t> swarm_neighbours(SwarmTopology topology, std::size_t i, std::size_t n);

}  // namespace proofmass
