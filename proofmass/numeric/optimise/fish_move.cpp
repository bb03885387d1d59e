// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "proofmass/numeric/optimise/fish_move_internal.hpp"

namespace proofmass {
namespace {

using Position = std::vector<double>;

double distance(const Position& a, const Position& b) {
  double sum = 0.0;
  for (std::size_t d = 0; d < a.size(); ++d) sum += (a[d] - b[d]) * (a[d] - b[d]);
  return std::sqrt(sum);
}

// A move from `from` towards `to`, at most as far as `to`.
Position towards(const Position& from, const Position& to, double stroke) {
  const double whole = distance(from, to);
  const double fraction = whole > stroke ? stroke / whole : 1.0;
  Position result = from;
  for (std::size_t d = 0; d < from.size(); ++d) result[d] += fraction * (to[d] - from[d]);
  return result;
}

// A point in a uniformly random direction at a uniformly random distance up to `radius`.
Position nearby(const Position& centre, double radius, RandomStream& random) {
  Position direction(centre.size());
  double squares = 0.0;
  for (double& x : direction) {
    x = random.normal();
    squares += x * x;
  }
  const double factor = radius * random.uniform() / std::sqrt(squares);
  for (std::size_t d = 0; d < centre.size(); ++d) direction[d] = centre[d] + factor * direction[d];
  return direction;
}

}  // namespace

void FishMove::operator()(Fish& fish, std::size_t i) const {
  fish.best = {};
  const std::vector<std::size_t> seen = in_sight(i);
  FishPlace swarmed = swarm(fish, seen);
  FishPlace followed = follow(fish, seen);
  fish.place = followed.value < swarmed.value ? std::move(followed) : std::move(swarmed);
}

FishPlace FishMove::look(Fish& fish, Position position) const {
  const double value = objective_(position);
  FishPlace place{.position = std::move(position),
                  .value = std::isnan(value) ? std::numeric_limits<double>::infinity() : value};
  ++fish.evaluations;
  if (fish.best.position.empty() || place.value < fish.best.value) fish.best = place;
  return place;
}

std::vector<std::size_t> FishMove::in_sight(std::size_t i) const {
  std::vector<std::size_t> seen;
  for (std::size_t k = 0; k < school_.size(); ++k) {
    if (k != i && distance(school_[k].position, school_[i].position) <= visual_) seen.push_back(k);
  }
  return seen;
}

bool FishMove::crowded(const Position& place) const {
  const auto near = std::count_if(school_.begin(), school_.end(), [&](const FishPlace& other) {
    return distance(other.position, place) <= visual_;
  });
  return static_cast<double>(near) > settings_.crowd_factor * static_cast<double>(school_.size());
}

FishPlace FishMove::swarm(Fish& fish, const std::vector<std::size_t>& seen) const {
  if (seen.empty()) return prey(fish);
  Position centre(fish.place.position.size(), 0.0);
  for (const std::size_t k : seen) {
    for (std::size_t d = 0; d < centre.size(); ++d) centre[d] += school_[k].position[d];
  }
  for (double& x : centre) x /= static_cast<double>(seen.size());
  return go(fish, look(fish, std::move(centre)));
}

FishPlace FishMove::follow(Fish& fish, const std::vector<std::size_t>& seen) const {
  const auto best = std::min_element(seen.begin(), seen.end(), [this](std::size_t a, std::size_t b) {
    return school_[a].value < school_[b].value;
  });
  return best == seen.end() ? prey(fish) : go(fish, school_[*best]);
}

FishPlace FishMove::go(Fish& fish, const FishPlace& target) const {
  if (!(target.value < fish.place.value) || crowded(target.position)) return prey(fish);
  return look(fish, towards(fish.place.position, target.position, step_ * fish.random.uniform()));
}

FishPlace FishMove::prey(Fish& fish) const {
  for (std::size_t k = 0; k < settings_.tries; ++k) {
    const FishPlace seen = look(fish, nearby(fish.place.position, visual_, fish.random));
    if (seen.value < fish.place.value)
      return look(fish, towards(fish.place.position, seen.position, step_ * fish.random.uniform()));
  }
  return look(fish, nearby(fish.place.position, step_, fish.random));
}

}  // namespace proofmass
