// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/regression/residual_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "proofmass/numeric/random.hpp"
#include "proofmass/numeric/regression/robust_regression.hpp"

namespace proofmass {
namespace {

TEST(GridStep, IsFoundThroughDecimalRoundingAndOnlyThere) {
  RandomStream random(1);
  std::vector<double> counts, decimals, continuous;
  for (int k = 0; k < 300; ++k) {
    continuous.push_back(random.uniform(-10.0, 10.0));
    counts.push_back(std::round(100.0 * continuous.back()));
    decimals.push_back(0.001 * std::round(1000.0 * continuous.back()) + 5.0);
  }
  EXPECT_EQ(grid_step(counts), 1.0);
  EXPECT_NEAR(grid_step(decimals), 0.001, 1e-12);
  EXPECT_EQ(grid_step(continuous), 0.0);
  EXPECT_EQ(grid_step(std::vector<double>{1.0, 2.0, 3.0, 4.0, 4.0}), 0.0);
}

using Noise = std::function<double(RandomStream&)>;

// Of 100 records of 312 rows, a surface of four terms with such noise: those whose scale is doubtful.
int doubtful_records(const Noise& noise) {
  int doubtful = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    RandomStream random(seed);
    Matrix design(312, 4);
    std::vector<double> y;
    for (std::size_t r = 0; r < 312; ++r) {
      const double x = random.uniform(-10.0, 10.0);
      design(r, 0) = 1.0;
      design(r, 1) = x;
      design(r, 2) = x * x;
      design(r, 3) = random.uniform(-10.0, 10.0);
      y.push_back(3.0 + x + 0.1 * x * x + 0.5 * design(r, 3) + noise(random));
    }
    if (fit_robustly(design, y).scale_check.doubtful) ++doubtful;
  }
  return doubtful;
}

TEST(ScaleCheck, TrustsNoiseWithOnePeakAndFewOutliers) {
  EXPECT_EQ(doubtful_records([](RandomStream& random) { return random.normal(); }), 0);
  EXPECT_LE(doubtful_records([](RandomStream& random) { return random.student_t(3.0); }), 1);
  EXPECT_LE(doubtful_records([](RandomStream& random) {
              return random.normal() + (random.uniform(0.0, 1.0) < 0.1 ? 100.0 : 0.0);
            }),
            1);
}

TEST(ScaleCheck, DoubtsRecordsThatAreNearlyHalfOutliers) {
  const auto outlier = [](RandomStream& random) { return random.uniform(0.0, 1.0) < 0.45; };
  EXPECT_GE(doubtful_records(
                [&](RandomStream& random) { return random.normal() + (outlier(random) ? 100.0 : 0.0); }),
            80);
  EXPECT_GE(doubtful_records([&](RandomStream& random) {
              const double side = random.uniform(0.0, 1.0) < 0.5 ? -100.0 : 100.0;
              return random.normal() + (outlier(random) ? side : 0.0);
            }),
            80);
}

// A line through counts, with noise of half a count: least squares is right, and most residuals of the line
// that runs through the grid are zero.
TEST(RobustScale, DoesNotFallBelowTheOutputsResolution) {
  for (const LossKind loss : {LossKind::huber, LossKind::bisquare, LossKind::student}) {
    RandomStream random(3);
    Matrix design(105, 2);
    std::vector<double> y;
    for (std::size_t r = 0; r < 105; ++r) {
      design(r, 0) = 1.0;
      design(r, 1) = static_cast<double>(r / 5) - 10.0;
      y.push_back(std::round(7.0 + 100.0 * design(r, 1) + 0.45 * random.normal()));
    }
    const RobustFit fit = fit_robustly(design, y, {.loss = loss});
    EXPECT_TRUE(fit.scale_floored);
    EXPECT_EQ(fit.resolution, 1.0);
    EXPECT_EQ(fit.scale_floor, 1.0 / std::sqrt(12.0));
    EXPECT_NEAR(fit.scale, 0.53, 0.12);
    EXPECT_FALSE(fit.scale_check.doubtful);
    // The asymptotic formulas are for continuous residuals: within a factor of two of least squares.
    const double error = std::sqrt(fit.covariance(0, 0));
    EXPECT_GT(error, 0.5 * 0.53 / std::sqrt(105.0));
    EXPECT_LT(error, 2.0 * 0.53 / std::sqrt(105.0));
    EXPECT_NEAR(fit.coefficients[0], 7.0, 0.15);
    y[50] += 20.0;
    EXPECT_LT(fit_robustly(design, y, {.loss = loss}).weights[50], 0.1);
  }
}

}  // namespace
}  // namespace proofmass
