// SPDX-License-Identifier: Apache-2.0
// Convergence of swarms on the usual test functions: medians over nine seeds of 50 particles and 1000
// iterations, starting at rest and uniform in the function's usual box.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "proofmass/numeric/optimise/particle_swarm.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

double sphere(std::span<const double> x) { return std::inner_product(x.begin(), x.end(), x.begin(), 0.0); }

double rosenbrock(std::span<const double> x) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    sum += 100.0 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1.0 - x[i], 2);
  }
  return sum;
}

double ackley(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  double waves = 0.0;
  for (const double value : x) waves += std::cos(2.0 * std::numbers::pi * value);
  return 20.0 - 20.0 * std::exp(-0.2 * std::sqrt(sphere(x) / n)) + std::numbers::e - std::exp(waves / n);
}

struct Problem {
  double (*function)(std::span<const double>);
  std::size_t dimensions;
  double half_width;  // of the initial box
};

double median_best(const Problem& problem, const SwarmSettings& settings) {
  constexpr std::size_t seeds = 9;
  std::vector<double> bests(seeds);
  parallel_for(seeds, [&](std::size_t seed) {
    RandomStream random(seed, stream_id("initial"));
    std::vector<std::vector<double>> initial(50, std::vector<double>(problem.dimensions));
    for (auto& position : initial) {
      for (double& x : position) x = random.uniform(-problem.half_width, problem.half_width);
    }
    const SwarmResult result = minimise_by_swarm(problem.function, initial, settings, seed);
    bests[seed] = result.history.back();
  });
  std::nth_element(bests.begin(), bests.begin() + seeds / 2, bests.end());
  return bests[seeds / 2];
}

// Shi et al.'s coefficients.
SwarmSettings paper(SwarmUpdate update, SwarmTopology topology) {
  return {.iterations = 1000,
          .inertia = 0.6,
          .cognitive = 1.5,
          .social = 1.5,
          .update = update,
          .topology = topology};
}

TEST(SwarmConvergence, PaperCoefficientsStagnateOnlyWhenSynchronousAndGlobal) {
  const Problem problem{sphere, 30, 100.0};
  EXPECT_LT(median_best(problem, paper(SwarmUpdate::asynchronous, SwarmTopology::global)), 1e-30);
  EXPECT_GT(median_best(problem, paper(SwarmUpdate::synchronous, SwarmTopology::global)), 1e-3);
  EXPECT_LT(median_best(problem, paper(SwarmUpdate::synchronous, SwarmTopology::ring)), 1e-12);
}

// With the constriction coefficients, pagmo 2.18's medians in ten dimensions with one global best are 5e-29
// on the sphere, 2.6 on Rosenbrock's function and 4e-15 on Ackley's. On a ring they are 2e-50, 0.71 and
// 4e-15.
TEST(SwarmConvergence, ConstrictionReachesWhatOtherImplementationsReach) {
  SwarmSettings settings{.iterations = 1000, .update = SwarmUpdate::asynchronous};
  EXPECT_LT(median_best({sphere, 10, 5.12}, settings), 1e-24);
  EXPECT_LT(median_best({rosenbrock, 10, 5.0}, settings), 10.0);
  EXPECT_LT(median_best({ackley, 10, 30.0}, settings), 1e-13);
  settings.topology = SwarmTopology::global;
  EXPECT_LT(median_best({sphere, 10, 5.12}, settings), 1e-44);
  EXPECT_LT(median_best({rosenbrock, 10, 5.0}, settings), 5.0);
  EXPECT_LT(median_best({ackley, 10, 30.0}, settings), 1e-13);
}

TEST(SwarmConvergence, TheDefaultSettingsConverge) {
  EXPECT_LT(median_best({sphere, 10, 5.12}, {.iterations = 1000}), 1e-20);
  EXPECT_LT(median_best({rosenbrock, 10, 5.0}, {.iterations = 1000}), 10.0);
  EXPECT_LT(median_best({ackley, 10, 30.0}, {.iterations = 1000}), 1e-12);
}

}  // namespace
}  // namespace proofmass
