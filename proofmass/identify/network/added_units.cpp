// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/added_units.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/network/separable_pool_internal.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"
#include "proofmass/numeric/optimise/particle_swarm.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kParticles = 40;
constexpr std::size_t kIterations = 30;
constexpr std::size_t kStarts = 16;
// Lengths of the weights of a unit as it starts, of inputs scaled to [-1, 1]: from units that are almost
// straight to such as bend within a quarter of the range, as |Ai|Ai does.
constexpr double kLeast = 0.5;
constexpr double kMost = 4.0;

// A unit whose middle lies within the range of the inputs.
std::vector<double> draw_unit(std::size_t inputs, RandomStream random) {
  const double length = kLeast * std::pow(kMost / kLeast, random.uniform());
  std::vector<double> unit(inputs);
  double square = 0.0;
  for (double& w : unit) {
    w = random.normal();
    square += w * w;
  }
  for (double& w : unit) w *= length / std::sqrt(square);
  unit.push_back(length * random.uniform(-1.0, 1.0));
  return unit;
}

// Hidden weights of the network and the unit, in the order of PerceptronShape.
std::vector<double> joined(const PerceptronShape& shape, std::span<const double> weights,
                           const std::vector<double>& unit) {
  const std::span<const double> directions = weights.first(shape.hidden * shape.inputs);
  const std::span<const double> biases = weights.subspan(directions.size(), shape.hidden);
  std::vector<double> all(directions.begin(), directions.end());
  all.insert(all.end(), unit.begin(), unit.end() - 1);
  all.insert(all.end(), biases.begin(), biases.end());
  all.push_back(unit.back());
  return all;
}

// The swarm keeps no more than its own best positions: the network's activations are fixed columns.
SwarmResult seek(const PerceptronShape& shape, std::span<const double> weights, const Samples& samples,
                 std::uint64_t seed, const Progress& progress) {
  ColumnBlock fixed(shape.hidden, samples.padded_rows());
  hidden_activations(shape, weights.first(shape.hidden_weights()), samples, fixed);
  const PerceptronShape unit{shape.inputs, 1};
  const SeparablePool pool(unit, samples, fixed);
  std::vector<std::vector<double>> initial;
  for (std::size_t i = 0; i < kParticles; ++i) {
    initial.push_back(
        draw_unit(shape.inputs, RandomStream(seed, stream_id("unit", kParticles * shape.hidden + i))));
  }
  return minimise_by_swarm(
      [&pool](std::span<const double> x) { return pool.rmse(x); }, std::move(initial),
      {.iterations = kIterations, .lower = -kMost, .upper = kMost, .velocity_limit = 0.5}, seed,
      [&progress](std::size_t, double) { return !progress.cancelled(); });
}

}  // namespace

std::vector<std::vector<double>> starts_with_added_unit(const PerceptronShape& shape,
                                                        std::span<const double> weights,
                                                        const Samples& samples, std::uint64_t seed,
                                                        const Progress& progress) {
  const SwarmResult swarm = seek(shape, weights, samples, seed, progress);
  if (progress.cancelled()) throw Error(ErrorKind::interrupted, "interrupted");
  std::vector<std::size_t> order(swarm.positions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&swarm](std::size_t a, std::size_t b) { return swarm.values[a] < swarm.values[b]; });
  std::vector<std::vector<double>> starts;
  for (std::size_t i = 0; i < kStarts; ++i)
    starts.push_back(joined(shape, weights, swarm.positions[order[i]]));
  return starts;
}

}  // namespace proofmass
