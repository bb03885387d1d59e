// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/optimise/fish_swarm.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>

#include "proofmass/numeric/parallel.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

std::vector<std::vector<double>> school(std::size_t fish, std::size_t dimensions, std::uint64_t seed) {
  std::vector<std::vector<double>> positions(fish, std::vector<double>(dimensions));
  RandomStream random(seed, stream_id("school"));
  for (auto& position : positions) {
    for (double& x : position) x = random.uniform(-1.0, 1.0);
  }
  return positions;
}

double sphere(std::span<const double> x) {
  double sum = 0.0;
  for (const double v : x) sum += (v - 0.3) * (v - 0.3);
  return sum;
}

double rastrigin(std::span<const double> x) {
  double sum = 0.0;
  for (const double v : x) sum += v * v + 0.1 * (1.0 - std::cos(20.0 * v));
  return sum;
}

FishSettings settings(std::size_t iterations = 100) {
  return {.iterations = iterations, .visual = 2.0, .step = 2.0, .target = {}};
}

TEST(FishSwarm, ReachesTheMinimumOfASphereToRounding) {
  const FishResult result = minimise_by_fish(sphere, school(40, 10, 1), settings(400), 1);
  for (const double x : result.best) EXPECT_NEAR(x, 0.3, 1e-9);
  EXPECT_EQ(result.value, sphere(result.best));
  EXPECT_EQ(result.termination.cause, Cause::iteration_limit);
}

TEST(FishSwarm, ImprovedFormBeatsThePlainOne) {
  FishSettings plain = settings(300);
  plain.decay = false;
  const double improved = minimise_by_fish(sphere, school(30, 6, 2), settings(300), 2).value;
  EXPECT_LT(improved, 1e-6 * minimise_by_fish(sphere, school(30, 6, 2), plain, 2).value);
}

TEST(FishSwarm, SameBitsForAnyThreads) {
  const auto with_threads = [](std::size_t threads) {
    const ThreadLimit limit(threads);
    return minimise_by_fish(rastrigin, school(20, 5, 3), settings(), 3);
  };
  const FishResult one = with_threads(1);
  const FishResult three = with_threads(3);
  EXPECT_EQ(one.best, three.best);
  EXPECT_EQ(one.history, three.history);
  EXPECT_EQ(one.mean_history, three.mean_history);
  EXPECT_EQ(one.evaluations, three.evaluations);
}

// The best of all positions that any fish looked at or moved to.
RC_GTEST_PROP(FishSwarm, BulletinIsTheLeastOfAllThatWasSeen, (std::uint64_t seed)) {
  std::mutex mutex;
  double least = std::numeric_limits<double>::infinity();
  std::size_t seen = 0;
  const auto objective = [&](std::span<const double> x) {
    const double value = rastrigin(x);
    const std::lock_guard lock(mutex);
    least = std::min(least, value);
    ++seen;
    return value;
  };
  const FishResult result = minimise_by_fish(objective, school(8, 3, seed), settings(20), seed);
  RC_ASSERT(result.value == least);
  RC_ASSERT(rastrigin(result.best) == least);
  RC_ASSERT(result.evaluations == seen);
  RC_ASSERT(result.history.size() == 21U);
  RC_ASSERT(std::is_sorted(result.history.rbegin(), result.history.rend()));
}

// Steps of 2^-20 are exact after the shift and the scaling, so no comparison can change.
RC_GTEST_PROP(FishSwarm, CourseIgnoresOffsetScaleAndSign, (std::uint64_t seed)) {
  const auto stepped = [](std::span<const double> x) { return std::round(rastrigin(x) * 0x1p20) * 0x1p-20; };
  const auto run = [seed](const FishObjective& objective) {
    return minimise_by_fish(objective, school(8, 3, seed), settings(20), seed);
  };
  const FishResult plain = run(stepped);
  RC_ASSERT(plain.best == run([&](auto x) { return stepped(x) - 4096.0; }).best);
  RC_ASSERT(plain.best == run([&](auto x) { return 8.0 * stepped(x) + 1024.0; }).best);
}

TEST(FishSwarm, NotANumberIsWorseThanAnything) {
  const auto half = [](std::span<const double> x) {
    return x[0] < 0.0 ? std::numeric_limits<double>::quiet_NaN() : sphere(x);
  };
  EXPECT_LT(minimise_by_fish(half, school(20, 2, 4), settings(), 4).value, 1e-9);
  const auto nothing = [](std::span<const double>) { return std::numeric_limits<double>::quiet_NaN(); };
  const FishResult lost = minimise_by_fish(nothing, school(5, 2, 4), settings(5), 4);
  EXPECT_EQ(lost.value, std::numeric_limits<double>::infinity());
  EXPECT_EQ(lost.best.size(), 2U);
}

// A place is crowded when more than this fraction of the school sees it. With a fraction of zero all fish
// prey.
TEST(FishSwarm, CrowdFactorKeepsFishApart) {
  const auto spread = [](double crowd_factor) {
    FishSettings choice = settings(30);
    choice.decay = false;
    choice.crowd_factor = crowd_factor;
    return minimise_by_fish(sphere, school(20, 4, 5), choice, 5).mean_history.back();
  };
  EXPECT_LT(spread(1.0), 0.5 * spread(0.0));
}

TEST(FishSwarm, EndsAtTargetStallAndObserver) {
  FishSettings target = settings();
  target.target = 0.5;
  const FishResult reached = minimise_by_fish(sphere, school(10, 3, 6), target, 6);
  EXPECT_EQ(reached.termination.cause, Cause::target_reached);
  EXPECT_LE(reached.value, 0.5);

  FishSettings stall = settings();
  stall.stall_iterations = 4;
  const auto flat = [](std::span<const double>) { return 1.0; };
  const FishResult stalled = minimise_by_fish(flat, school(10, 3, 6), stall, 6);
  EXPECT_EQ(stalled.termination.cause, Cause::stalled);
  EXPECT_EQ(stalled.history.size(), 5U);

  const auto observe = [](std::size_t iteration, double) { return iteration < 3; };
  const FishResult stopped = minimise_by_fish(sphere, school(10, 3, 6), settings(), 6, observe);
  EXPECT_EQ(stopped.termination.cause, Cause::stopped);
  EXPECT_EQ(stopped.history.size(), 4U);
}

TEST(FishSwarm, RefusesWhatMakesNoSense) {
  EXPECT_THROW((void)minimise_by_fish(sphere, {}, settings(), 1), std::invalid_argument);
  EXPECT_THROW((void)minimise_by_fish(sphere, {{0.0}, {0.0, 1.0}}, settings(), 1), std::invalid_argument);
  FishSettings blind = settings();
  blind.visual = 0.0;
  EXPECT_THROW((void)minimise_by_fish(sphere, school(4, 2, 1), blind, 1), std::invalid_argument);
}

}  // namespace
}  // namespace proofmass
