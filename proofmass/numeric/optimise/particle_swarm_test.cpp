// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/optimise/particle_swarm.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <set>
#include <thread>

#include "proofmass/numeric/parallel.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

using Positions = std::vector<std::vector<double>>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double sphere(std::span<const double> x) { return std::inner_product(x.begin(), x.end(), x.begin(), 0.0); }

Positions uniform_swarm(std::size_t particles, std::size_t dimensions, double half_width,
                        std::uint64_t seed) {
  RandomStream random(seed, stream_id("initial"));
  Positions positions(particles, std::vector<double>(dimensions));
  for (auto& position : positions) {
    for (double& x : position) x = random.uniform(-half_width, half_width);
  }
  return positions;
}

void expect_same(const SwarmResult& a, const SwarmResult& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.values, b.values);
  EXPECT_EQ(a.history, b.history);
  EXPECT_EQ(a.mean_history, b.mean_history);
  EXPECT_EQ(a.best, b.best);
  EXPECT_EQ(a.evaluations, b.evaluations);
}

class Swarm : public testing::TestWithParam<std::tuple<SwarmUpdate, SwarmTopology>> {
 protected:
  static SwarmSettings settings(std::size_t iterations) {
    return {.iterations = iterations, .update = std::get<0>(GetParam()), .topology = std::get<1>(GetParam())};
  }
};
INSTANTIATE_TEST_SUITE_P(Variants, Swarm,
                         testing::Combine(testing::Values(SwarmUpdate::synchronous,
                                                          SwarmUpdate::asynchronous),
                                          testing::Values(SwarmTopology::global, SwarmTopology::ring,
                                                          SwarmTopology::von_neumann)));

TEST_P(Swarm, SameSeedSameBitsForAnyNumberOfThreads) {
  const auto run = [&](std::size_t threads, std::uint64_t seed) {
    const ThreadLimit limit(threads);
    return minimise_by_swarm(sphere, uniform_swarm(17, 5, 3.0, 1), settings(40), seed);
  };
  const SwarmResult one = run(1, 7);
  expect_same(one, run(2, 7));
  expect_same(one, run(4, 7));
  EXPECT_NE(one.history, run(1, 8).history);
}

TEST_P(Swarm, ResultIsConsistentAndNeverGetsWorse) {
  const SwarmResult result = minimise_by_swarm(sphere, uniform_swarm(12, 4, 2.0, 2), settings(50), 3);
  EXPECT_EQ(result.termination.cause, Cause::iteration_limit);
  EXPECT_EQ(result.evaluations, 12U * 51U);
  ASSERT_EQ(result.history.size(), 51U);
  ASSERT_EQ(result.mean_history.size(), 51U);
  EXPECT_TRUE(std::is_sorted(result.history.rbegin(), result.history.rend()));
  EXPECT_TRUE(std::is_sorted(result.mean_history.rbegin(), result.mean_history.rend()));
  EXPECT_LT(result.history.back(), 1e-2 * result.history.front());
  double sum = 0.0;
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(sphere(result.positions[i]), result.values[i]);
    sum += result.values[i];
  }
  EXPECT_EQ(result.values[result.best], *std::min_element(result.values.begin(), result.values.end()));
  EXPECT_EQ(result.values[result.best], result.history.back());
  EXPECT_DOUBLE_EQ(result.mean_history.back(), sum / 12.0);
  // Its bests can be the start of another swarm.
  const SwarmResult next = minimise_by_swarm(sphere, result.positions, settings(20), 4);
  EXPECT_EQ(next.history.front(), result.history.back());
  EXPECT_LT(next.history.back(), next.history.front());
}

TEST_P(Swarm, StartsFromTheInitialSwarm) {
  const Positions initial{{3.0, 1.0}, {0.5, -0.5}, {-0.5, 0.5}, {2.0, 2.0}};
  const SwarmResult result = minimise_by_swarm(sphere, initial, settings(0), 1);
  EXPECT_EQ(result.positions, initial);
  EXPECT_EQ(result.values, (std::vector<double>{10.0, 0.5, 0.5, 8.0}));
  EXPECT_EQ(result.best, 1U);
  EXPECT_EQ(result.history, std::vector<double>{0.5});
  EXPECT_EQ(result.mean_history, std::vector<double>{4.75});
  EXPECT_EQ(result.evaluations, 4U);
}

TEST_P(Swarm, NotANumberCountsAsInfinity) {
  const auto half = [](std::span<const double> x) { return x[0] < 1.0 ? std::nan("") : sphere(x); };
  Positions initial = uniform_swarm(9, 2, 0.9, 3);
  initial[4] = {2.0, 0.0};
  const SwarmResult result = minimise_by_swarm(half, initial, settings(60), 5);
  EXPECT_EQ(result.history.front(), 4.0);
  EXPECT_EQ(result.mean_history.front(), 4.0);
  EXPECT_GE(result.history.back(), 1.0);
  EXPECT_LT(result.history.back(), 4.0);
  for (const double value : result.values) EXPECT_FALSE(std::isnan(value));

  const auto never = [](std::span<const double>) { return std::nan(""); };
  const SwarmResult lost = minimise_by_swarm(never, initial, settings(5), 5);
  EXPECT_EQ(lost.positions, initial);
  EXPECT_EQ(lost.values, std::vector<double>(9, kInfinity));
  EXPECT_EQ(lost.history, std::vector<double>(6, kInfinity));
}

TEST_P(Swarm, EndsByTargetStallAndObserver) {
  const Positions initial = uniform_swarm(10, 2, 1.0, 4);
  SwarmSettings aimed = settings(500);
  aimed.target = 1e-3;
  const SwarmResult reached = minimise_by_swarm(sphere, initial, aimed, 1);
  EXPECT_EQ(reached.termination.cause, Cause::target_reached);
  EXPECT_LE(reached.history.back(), 1e-3);
  ASSERT_GE(reached.history.size(), 2U);
  EXPECT_GT(reached.history[reached.history.size() - 2], 1e-3);
  // The target is also reached when it takes the last iteration allowed.
  aimed.iterations = reached.history.size() - 1;
  EXPECT_EQ(minimise_by_swarm(sphere, initial, aimed, 1).termination.cause, Cause::target_reached);

  SwarmSettings patient = settings(500);
  patient.stall_iterations = 7;
  const SwarmResult stalled =
      minimise_by_swarm([](std::span<const double>) { return 2.0; }, initial, patient, 1);
  EXPECT_EQ(stalled.termination.cause, Cause::stalled);
  EXPECT_EQ(stalled.history.size(), 8U);

  std::vector<std::pair<std::size_t, double>> seen;
  const SwarmResult stopped =
      minimise_by_swarm(sphere, initial, settings(500), 1, [&](std::size_t iteration, double best) {
        seen.emplace_back(iteration, best);
        return iteration < 5;
      });
  EXPECT_EQ(stopped.termination.cause, Cause::stopped);
  ASSERT_EQ(stopped.history.size(), 6U);
  ASSERT_EQ(seen.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(seen[i], std::pair(i + 1, stopped.history[i + 1]));
}

// Positions in the order of their evaluation.
Positions evaluated_positions(const Positions& initial, const SwarmSettings& settings) {
  Positions seen;
  std::mutex mutex;
  // The function falls without limit towards the lower left, so particles leave any box.
  const auto slope = [&](std::span<const double> x) {
    const std::scoped_lock lock(mutex);
    seen.emplace_back(x.begin(), x.end());
    return std::accumulate(x.begin(), x.end(), 0.0);
  };
  (void)minimise_by_swarm(slope, initial, settings, 6);
  return seen;
}

std::size_t count_outside(const Positions& positions, double lower, double upper) {
  std::size_t count = 0;
  for (const auto& position : positions) {
    count += static_cast<std::size_t>(
        std::any_of(position.begin(), position.end(), [&](double x) { return !(x >= lower && x <= upper); }));
  }
  return count;
}

TEST_P(Swarm, WallsHoldAndTheirAbsenceDoesNot) {
  const Positions initial = uniform_swarm(12, 3, 1.0, 5);
  SwarmSettings box = settings(60);
  box.lower = -1.5;
  box.upper = 1.25;
  EXPECT_GT(count_outside(evaluated_positions(initial, box), -1.5, 1.25), 100U);
  box.walls = SwarmWalls::absorb;
  const Positions absorbed = evaluated_positions(initial, box);
  EXPECT_EQ(count_outside(absorbed, -1.5, 1.25), 0U);
  const auto corner = std::vector<double>(3, -1.5);
  EXPECT_NE(std::find(absorbed.begin(), absorbed.end(), corner), absorbed.end());
  box.walls = SwarmWalls::reflect;
  EXPECT_EQ(count_outside(evaluated_positions(initial, box), -1.5, 1.25), 0U);
}

TEST(SwarmMotion, AsynchronousSwarmsStayOnTheCallersThread) {
  const ThreadLimit limit(4);
  std::set<std::thread::id> threads;
  std::mutex mutex;
  const auto watched = [&](std::span<const double> x) {
    const std::scoped_lock lock(mutex);
    threads.insert(std::this_thread::get_id());
    return sphere(x);
  };
  (void)minimise_by_swarm(watched, uniform_swarm(200, 2, 1.0, 1),
                          {.iterations = 20, .update = SwarmUpdate::asynchronous}, 1);
  EXPECT_EQ(threads, std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST(SwarmMotion, VelocityLimitIsAShareOfTheBox) {
  constexpr std::size_t particles = 6;
  const SwarmSettings settings{.iterations = 80,
                               .update = SwarmUpdate::asynchronous,
                               .lower = -2.0,
                               .upper = 3.0,
                               .velocity_limit = 0.05};
  const Positions seen = evaluated_positions(uniform_swarm(particles, 2, 2.0, 7), settings);
  ASSERT_EQ(seen.size(), particles * 81U);
  double longest = 0.0;
  for (std::size_t i = particles; i < seen.size(); ++i) {
    for (std::size_t d = 0; d < 2; ++d) {
      longest = std::max(longest, std::abs(seen[i][d] - seen[i - particles][d]));
    }
  }
  EXPECT_NEAR(longest, 0.25, 1e-12);
}

// Particles that remember only their neighbours' bests: a particle that moves has seen a better one.
std::vector<std::size_t> moved_after_one_iteration(SwarmUpdate update, SwarmTopology topology) {
  Positions initial(16, {1.0});
  initial[3] = {0.0};
  const SwarmSettings settings{.iterations = 1,
                               .inertia = 0.0,
                               .cognitive = 0.0,
                               .social = 1.0,
                               .update = update,
                               .topology = topology};
  const SwarmResult result = minimise_by_swarm(sphere, initial, settings, 2);
  std::vector<std::size_t> moved;
  for (std::size_t i = 0; i < initial.size(); ++i) {
    if (result.positions[i] != initial[i]) moved.push_back(i);
  }
  return moved;
}

TEST(SwarmMotion, ABetterPositionSpreadsOneNeighbourhoodAStepOrAtOnce) {
  for (const auto topology : {SwarmTopology::global, SwarmTopology::ring, SwarmTopology::von_neumann}) {
    EXPECT_EQ(moved_after_one_iteration(SwarmUpdate::synchronous, topology),
              swarm_neighbours(topology, 3, 16));
  }
  // 2 moves after 1, 1 after 0, and 0 before anybody next to it has seen 3; all after 3 hear of it in turn.
  EXPECT_EQ(moved_after_one_iteration(SwarmUpdate::asynchronous, SwarmTopology::ring),
            (std::vector<std::size_t>{2, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}));
}

TEST(SwarmNeighbours, OfEachTopology) {
  EXPECT_EQ(swarm_neighbours(SwarmTopology::ring, 0, 6), (std::vector<std::size_t>{1, 5}));
  EXPECT_EQ(swarm_neighbours(SwarmTopology::ring, 4, 6), (std::vector<std::size_t>{3, 5}));
  EXPECT_EQ(swarm_neighbours(SwarmTopology::global, 2, 4), (std::vector<std::size_t>{0, 1, 3}));
  EXPECT_EQ(swarm_neighbours(SwarmTopology::von_neumann, 5, 16), (std::vector<std::size_t>{1, 4, 6, 9}));
  for (const auto topology : {SwarmTopology::global, SwarmTopology::ring, SwarmTopology::von_neumann}) {
    EXPECT_TRUE(swarm_neighbours(topology, 0, 1).empty());
    EXPECT_EQ(swarm_neighbours(topology, 0, 2), std::vector<std::size_t>{1});
  }
}

RC_GTEST_PROP(SwarmNeighboursProperty, AreMutualDistinctOthers, ()) {
  const auto n = *rc::gen::inRange<std::size_t>(1, 70);
  const auto i = *rc::gen::inRange<std::size_t>(0, n);
  for (const auto topology : {SwarmTopology::global, SwarmTopology::ring, SwarmTopology::von_neumann}) {
    const auto neighbours = swarm_neighbours(topology, i, n);
    RC_ASSERT(std::set<std::size_t>(neighbours.begin(), neighbours.end()).size() == neighbours.size());
    if (topology == SwarmTopology::von_neumann && n > 6) RC_ASSERT(neighbours.size() == 4U);
    for (const std::size_t k : neighbours) {
      const auto back = swarm_neighbours(topology, k, n);
      RC_ASSERT(k < n && k != i);
      RC_ASSERT(std::count(back.begin(), back.end(), i) == 1);
    }
  }
}

TEST(SwarmMisuse, Throws) {
  EXPECT_THROW((void)minimise_by_swarm(sphere, {}, {}, 1), std::invalid_argument);
  EXPECT_THROW((void)minimise_by_swarm(sphere, {{1.0, 2.0}, {1.0}}, {}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace proofmass
