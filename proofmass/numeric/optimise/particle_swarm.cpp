// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/optimise/particle_swarm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "proofmass/numeric/parallel.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

struct Particle {
  std::vector<double> position, velocity, best_position;
  double value = 0.0;
  double best_value = std::numeric_limits<double>::infinity();
  RandomStream random;
  std::vector<std::size_t> neighbours;
};

class Swarm {
 public:
  Swarm(const SwarmObjective& objective, std::vector<std::vector<double>> initial,
        const SwarmSettings& settings, std::uint64_t seed)
      : objective_(objective), settings_(settings) {
    for (std::size_t i = 0; i < initial.size(); ++i) {
      particles_.push_back({.position = initial[i],
                            .velocity = std::vector<double>(initial[i].size(), 0.0),
                            .best_position = initial[i],
                            .random = RandomStream(seed, stream_id("particle", i)),
                            .neighbours = swarm_neighbours(settings.topology, i, initial.size())});
    }
    if (settings.update == SwarmUpdate::synchronous) {
      parallel_for(particles_.size(), [this](std::size_t i) { evaluate(particles_[i]); });
    } else {
      for (Particle& particle : particles_) evaluate(particle);
    }
    for (Particle& particle : particles_) renew_best(particle);
    record();
  }

  SwarmResult run(const SwarmObserver& observer) {
    for (std::size_t iteration = 1;; ++iteration) {
      if (settings_.target && best() <= *settings_.target) {
        return finish(ended(Cause::target_reached, Event::swarm_at_target,
                            {{"value", best()}, {"target", *settings_.target}}));
      }
      if (stalled()) {
        return finish(
            ended(Cause::stalled, Event::swarm_stalled, {{"iterations", settings_.stall_iterations}}));
      }
      if (iteration > settings_.iterations) {
        return finish(
            ended(Cause::iteration_limit, Event::swarm_spent, {{"iterations", settings_.iterations}}));
      }
      settings_.update == SwarmUpdate::synchronous ? iterate_synchronously() : iterate_asynchronously();
      record();
      if (observer && !observer(iteration, best()))
        return finish(ended(Cause::stopped, Event::stopped_by_observer));
    }
  }

 private:
  void evaluate(Particle& particle) const {
    const double value = objective_(particle.position);
    particle.value = std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  }

  static void renew_best(Particle& particle) {
    if (particle.value >= particle.best_value) return;
    particle.best_value = particle.value;
    particle.best_position = particle.position;
  }

  // The best position that particle i knows of.
  [[nodiscard]] std::vector<double> attractor(std::size_t i) const {
    std::size_t best = i;
    for (const std::size_t k : particles_[i].neighbours) {
      if (particles_[k].best_value < particles_[best].best_value) best = k;
    }
    return particles_[best].best_position;
  }

  // Shi & Eberhart 1998, eq. (1a), (1b).
  void move(Particle& particle, const std::vector<double>& attractor) const {
    const double limit = settings_.velocity_limit * (settings_.upper - settings_.lower);
    for (std::size_t d = 0; d < particle.position.size(); ++d) {
      double& x = particle.position[d];
      double& v = particle.velocity[d];
      const double own = settings_.cognitive * particle.random.uniform() * (particle.best_position[d] - x);
      const double others = settings_.social * particle.random.uniform() * (attractor[d] - x);
      v = settings_.inertia * v + own + others;
      if (limit > 0.0) v = std::clamp(v, -limit, limit);
      x += v;
      keep_inside(x, v);
    }
  }

  void keep_inside(double& x, double& v) const {
    if (settings_.walls == SwarmWalls::none || (x >= settings_.lower && x <= settings_.upper)) return;
    const double wall = std::clamp(x, settings_.lower, settings_.upper);
    x = settings_.walls == SwarmWalls::reflect ? std::clamp(2.0 * wall - x, settings_.lower, settings_.upper)
                                               : wall;
    v = settings_.walls == SwarmWalls::reflect ? -v : 0.0;
  }

  void iterate_synchronously() {
    std::vector<std::vector<double>> attractors(particles_.size());
    for (std::size_t i = 0; i < particles_.size(); ++i) attractors[i] = attractor(i);
    parallel_for(particles_.size(), [&](std::size_t i) {
      move(particles_[i], attractors[i]);
      evaluate(particles_[i]);
    });
    for (Particle& particle : particles_) renew_best(particle);
  }

  void iterate_asynchronously() {
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      move(particles_[i], attractor(i));
      evaluate(particles_[i]);
      renew_best(particles_[i]);
    }
  }

  void record() {
    result_.evaluations += particles_.size();
    double sum = 0.0;
    double count = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (const Particle& particle : particles_) {
      least = std::min(least, particle.best_value);
      if (!std::isfinite(particle.best_value)) continue;
      sum += particle.best_value;
      count += 1.0;
    }
    result_.history.push_back(least);
    result_.mean_history.push_back(count > 0.0 ? sum / count : least);
  }

  [[nodiscard]] double best() const { return result_.history.back(); }

  [[nodiscard]] bool stalled() const {
    const std::size_t window = settings_.stall_iterations;
    const auto& history = result_.history;
    return window > 0 && history.size() > window && !(best() < history[history.size() - 1 - window]);
  }

  SwarmResult finish(Termination termination) {
    result_.termination = std::move(termination);
    for (Particle& particle : particles_) {
      result_.positions.push_back(std::move(particle.best_position));
      result_.values.push_back(particle.best_value);
    }
    const auto least = std::min_element(result_.values.begin(), result_.values.end());
    result_.best = static_cast<std::size_t>(least - result_.values.begin());
    return std::move(result_);
  }

  const SwarmObjective& objective_;
  const SwarmSettings& settings_;
  std::vector<Particle> particles_;
  SwarmResult result_;
};

}  // namespace

std::vector<std::size_t> swarm_neighbours(SwarmTopology topology, std::size_t i, std::size_t n) {
  std::vector<std::size_t> neighbours;
  switch (topology) {
    case SwarmTopology::global:
      for (std::size_t k = 0; k < n; ++k) neighbours.push_back(k);
      break;
    case SwarmTopology::ring:
      neighbours = {(i + n - 1) % n, (i + 1) % n};
      break;
    case SwarmTopology::von_neumann: {
      // A torus as nearly square as n allows; steps by a row wrap around the swarm.
      const auto row = static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(n))));
      neighbours = {(i + n - 1) % n, (i + 1) % n, (i + n - row % n) % n, (i + row) % n};
      break;
    }
  }
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  std::erase(neighbours, i);
  return neighbours;
}

SwarmResult minimise_by_swarm(const SwarmObjective& objective, std::vector<std::vector<double>> initial,
                              const SwarmSettings& settings, std::uint64_t seed,
                              const SwarmObserver& observer) {
  if (initial.empty()) throw std::invalid_argument("a swarm needs at least one particle");
  for (const auto& position : initial) {
    if (position.size() != initial.front().size()) throw std::invalid_argument("particles differ in length");
  }
  return Swarm(objective, std::move(initial), settings, seed).run(observer);
}

}  // namespace proofmass
