// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/pso_bp.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/ending_of.hpp"
#include "proofmass/identify/network/growth.hpp"
#include "proofmass/identify/network/result.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/identify/network/swarm_fitness.hpp"
#include "proofmass/identify/network/training/refinement.hpp"
#include "proofmass/identify/network/training/starts.hpp"
#include "proofmass/identify/options/field_text.hpp"
#include "proofmass/numeric/optimise/particle_swarm.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

// Particles differ when some weight of their canonical forms differs by more than this.
constexpr double kDifferent = 0.1;

std::vector<std::vector<double>> initial_swarm(const NetworkTask& task, const PsoBp& method,
                                               std::uint64_t seed) {
  const bool separable = method.fitness == SwarmFitness::separable;
  const std::size_t length = separable ? task.shape.hidden_weights() : task.shape.parameters();
  std::vector<std::vector<double>> positions = method.initial;
  for (const auto& position : positions) {
    if (position.size() != length) {
      throw usage_error(message("an initial particle has {} weights, expected {}", position.size(), length));
    }
  }
  if (positions.size() > method.particles) {
    throw usage_error(
        message("{} initial positions for a swarm of {} particles", positions.size(), method.particles));
  }
  positions.resize(method.particles);
  for (std::size_t i = method.initial.size(); i < positions.size(); ++i) {
    positions[i] = random_start(task.shape, separable ? Trainer::varpro : Trainer::lm, seed, i);
  }
  return positions;
}

SwarmSettings settings_of(const PsoBp& method, const std::vector<std::vector<double>>& initial) {
  double reach = 0.0;
  for (const auto& position : initial) {
    for (const double x : position) reach = std::max(reach, std::abs(x));
  }
  return {.iterations = method.iterations,
          .inertia = method.inertia,
          .cognitive = method.cognitive,
          .social = method.social,
          .update = method.update,
          .topology = method.topology,
          .lower = -reach,
          .upper = reach,
          .velocity_limit = method.velocity_limit,
          .stall_iterations = method.stall_iterations,
          .target = method.target};
}

// The best particles, leaving out those that are one network in another guise.
std::vector<TrainingState> diverse_particles(const NetworkTask& task, const NetworkTrainer& trainer,
                                             const SwarmResult& swarm, std::size_t most, std::uint64_t seed) {
  std::vector<std::size_t> order(swarm.positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&swarm](std::size_t a, std::size_t b) { return swarm.values[a] < swarm.values[b]; });
  std::vector<TrainingState> chosen;
  std::vector<std::vector<double>> guises;
  for (const std::size_t i : order) {
    if (chosen.size() == most) break;
    TrainingState state = trainer.start(swarm.positions[i], RandomStream(seed, stream_id("kick", i)));
    std::vector<double> guise = canonical_weights(task.shape, state.weights);
    const auto same = [&](const std::vector<double>& other) {
      double difference = 0.0;
      for (std::size_t k = 0; k < task.shape.hidden_weights(); ++k) {
        difference = std::max(difference, std::abs(guise[k] - other[k]));
      }
      return difference <= kDifferent;
    };
    if (std::any_of(guises.begin(), guises.end(), same)) continue;
    guises.push_back(std::move(guise));
    chosen.push_back(std::move(state));
  }
  return chosen;
}

void add_swarm(Identification& result, const SwarmResult& swarm, std::optional<EndingPart> units,
               double scale) {
  const auto scaled = [scale](std::vector<double> values) {
    for (double& value : values) value *= scale;
    return values;
  };
  std::get<NetworkDetails>(result.details).swarm_evaluations = swarm.evaluations;
  result.history.push_back({"swarm_best", scaled(swarm.history)});
  result.history.push_back({"swarm_mean", scaled(swarm.mean_history)});
  result.ending.parts = {{.code = EndingCode::particle_swarm, .parts = ending_parts(swarm.termination)},
                         {.code = EndingCode::training, .parts = std::move(result.ending.parts)}};
  if (units) result.ending.parts.push_back(std::move(*units));
}

}  // namespace

Identification fit(const PsoBp& method, const Dataset& training, const Dataset& validation,
                   const IdentifyOptions& options, Progress& progress) {
  require_in_range(method);
  NetworkTask task = prepare_network(method.network, training, validation, options);
  const NetworkTrainer trainer(task.shape, task.samples, task.validation ? &*task.validation : nullptr,
                               method.network.training);
  const SwarmFitnessFunction fitness(task.shape, task.samples, method, progress);
  std::vector<std::vector<double>> initial = initial_swarm(task, method, options.seed);
  const SwarmSettings settings = settings_of(method, initial);
  const auto observe = [&](std::size_t iteration, double) {
    progress.update("swarm", iteration, settings.iterations);
    return !progress.cancelled();
  };
  const SwarmResult swarm = minimise_by_swarm([&fitness](std::span<const double> x) { return fitness(x); },
                                              std::move(initial), settings, options.seed, observe);
  if (progress.cancelled()) throw Error(ErrorKind::interrupted, "interrupted");

  // A network that may grow need not find among many candidates what more units find sooner.
  const GrowthPlan growth{
      .most_hidden = method.grow_to, .training = method.network.training, .seed = options.seed};
  const bool may_grow = hidden_limit(task, growth) > task.shape.hidden;
  std::vector<TrainingState> particles =
      diverse_particles(task, trainer, swarm,
                        may_grow ? std::min(method.refined, kRefinementBatch) : method.refined, options.seed);
  Refinement refinement =
      refine(trainer, std::move(particles),
             {.epochs = method.network.training.epochs, .good_enough = task.good_enough()}, progress);
  std::optional<EndingPart> units;
  if (may_grow) units = grow(task, refinement, growth, progress);
  refinement.epochs += fitness.epochs();
  Identification result =
      make_network_identification("pso-bp", task, method.network.extraction, options, refinement);
  add_swarm(result, swarm, std::move(units),
            output_half_range(task.network) / task.training.output_unit.to_canonical);
  // An evaluation that trains has been counted by its epochs.
  if (method.fitness != SwarmFitness::trained) {
    result.diagnostics.iterations = refinement.epochs + swarm.evaluations;
  }
  return result;
}

}  // namespace proofmass
