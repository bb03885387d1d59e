// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/regression/growing_variance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

struct Problem {
  Matrix design;
  std::vector<double> y;
  std::vector<double> growth;
};

Problem make_problem(std::size_t rows, double base, double slope, std::uint64_t seed) {
  RandomStream random(seed);
  Problem problem{.design = Matrix(rows, 2), .y = {}, .growth = {}};
  for (std::size_t r = 0; r < rows; ++r) {
    const double x = random.uniform(0.0, 10.0);
    problem.design(r, 0) = 1.0;
    problem.design(r, 1) = x;
    problem.growth.push_back(x * x);
    problem.y.push_back(3.0 + x + std::sqrt(base + slope * x * x) * random.normal());
  }
  return problem;
}

// The restricted log-likelihood, without its constants, computed with dense matrices.
double restricted_likelihood(const Problem& problem, double base, double slope) {
  const auto rows = static_cast<Eigen::Index>(problem.y.size());
  const Eigen::Map<const Eigen::MatrixXd> x(problem.design.data(), rows, 2);
  const Eigen::Map<const Eigen::VectorXd> y(problem.y.data(), rows);
  const Eigen::Map<const Eigen::ArrayXd> growth(problem.growth.data(), rows);
  const Eigen::ArrayXd variance = base + slope * growth;
  const Eigen::MatrixXd weighted = variance.inverse().matrix().asDiagonal() * x;
  const Eigen::MatrixXd normal = x.transpose() * weighted;
  const Eigen::VectorXd residual = y - x * normal.ldlt().solve(weighted.transpose() * y);
  return -0.5 * (variance.log().sum() + std::log(normal.determinant()) +
                 (residual.array().square() / variance).sum());
}

TEST(GrowingVariance, MaximisesTheRestrictedLikelihood) {
  const Problem problem = make_problem(60, 1.0, 0.05, 3);
  const GrowingVarianceFit fit = fit_growing_variance(problem.design, problem.y, problem.growth);
  ASSERT_EQ(fit.termination.cause, Cause::converged);
  ASSERT_GT(fit.base, 0.0);
  ASSERT_GT(fit.slope, 0.0);
  const double best = restricted_likelihood(problem, fit.base, fit.slope);
  for (const double factor : {0.99, 1.01}) {
    EXPECT_LT(restricted_likelihood(problem, factor * fit.base, fit.slope), best);
    EXPECT_LT(restricted_likelihood(problem, fit.base, factor * fit.slope), best);
  }
}

TEST(GrowingVariance, IsUnbiasedOnAverage) {
  double base = 0.0;
  double slope = 0.0;
  constexpr int repeats = 200;
  for (std::uint64_t seed = 1; seed <= repeats; ++seed) {
    const Problem problem = make_problem(100, 4.0, 0.25, seed);
    const GrowingVarianceFit fit = fit_growing_variance(problem.design, problem.y, problem.growth);
    base += fit.base / repeats;
    slope += fit.slope / repeats;
  }
  EXPECT_NEAR(base, 4.0, 0.5);     // three standard errors of the mean
  EXPECT_NEAR(slope, 0.25, 0.02);  // the same
}

TEST(GrowingVariance, EvenGrowthIsOrdinaryLeastSquares) {
  Problem problem = make_problem(40, 1.0, 0.0, 4);
  problem.growth.assign(40, 2.5);
  const GrowingVarianceFit fit = fit_growing_variance(problem.design, problem.y, problem.growth);
  const LeastSquaresFit plain = solve_least_squares(problem.design, problem.y);
  EXPECT_EQ(fit.slope, 0.0);
  EXPECT_EQ(fit.fit.coefficients, plain.coefficients);
  EXPECT_DOUBLE_EQ(fit.variance, plain.rss / static_cast<double>(plain.dof));
}

TEST(GrowingVariance, ShrinkingNoiseGivesTheBoundary) {
  Problem problem = make_problem(200, 1.0, 0.0, 5);
  for (std::size_t r = 0; r < 200; ++r) problem.growth[r] = 100.0 - problem.growth[r];
  RandomStream random(6);
  for (std::size_t r = 0; r < 200; ++r) {
    problem.y[r] = 3.0 + problem.design(r, 1) + std::sqrt(101.0 - problem.growth[r]) * random.normal();
  }
  EXPECT_EQ(fit_growing_variance(problem.design, problem.y, problem.growth).slope, 0.0);
}

TEST(GrowingVariance, RefusesNegativeGrowth) {
  Problem problem = make_problem(10, 1.0, 0.0, 7);
  problem.growth[3] = -1.0;
  EXPECT_THROW((void)fit_growing_variance(problem.design, problem.y, problem.growth), std::invalid_argument);
}

}  // namespace
}  // namespace proofmass
