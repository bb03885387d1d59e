// SPDX-License-Identifier: Apache-2.0
// The behaviour of one artificial fish: swarm, follow, prey (Li, Shao & Qian 2002).
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "proofmass/numeric/optimise/fish_swarm.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {

// A position and its value.
struct FishPlace {
  std::vector<double> position;
  double value = std::numeric_limits<double>::infinity();
};

struct Fish {
  FishPlace place;
  FishPlace best;  // the best position looked at or moved to in its last move
  RandomStream random;
  std::size_t evaluations = 0;
};

// One move of a school: computes where each fish would go, from the present positions of all fish.
class FishMove {
 public:
  // Keeps references. Visual and step are the values for this move.
  FishMove(const FishObjective& objective, const FishSettings& settings, const std::vector<FishPlace>& school,
           double visual, double step)
      : objective_(objective), settings_(settings), school_(school), visual_(visual), step_(step) {}

  // Moves fish i to the better of the results of swarming and following.
  void operator()(Fish& fish, std::size_t i) const;
  // Evaluates a position and remembers it if it is the best of this move.
  [[nodiscard]] FishPlace look(Fish& fish, std::vector<double> position) const;

 private:
  [[nodiscard]] std::vector<std::size_t> in_sight(std::size_t i) const;
  // Whether more than the crowd factor's fraction of the school is in sight of a position (Li's n_f / N
  // against delta).
  [[nodiscard]] bool crowded(const std::vector<double>& place) const;
  [[nodiscard]] FishPlace swarm(Fish& fish, const std::vector<std::size_t>& seen) const;
  [[nodiscard]] FishPlace follow(Fish& fish, const std::vector<std::size_t>& seen) const;
  // A move towards a better position that is not crowded; otherwise prey.
  [[nodiscard]] FishPlace go(Fish& fish, const FishPlace& target) const;
  // A move towards the first better point seen; a random move when there is none.
  [[nodiscard]] FishPlace prey(Fish& fish) const;

  const FishObjective& objective_;
  const FishSettings& settings_;
  const std::vector<FishPlace>& school_;
  double visual_;
  double step_;
};

}  // namespace proofmass
