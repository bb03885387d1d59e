// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/weighted_least_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

struct Problem {
  Matrix design;
  std::vector<double> y;
};

Problem make_problem(std::size_t rows) {
  RandomStream random(5);
  Problem problem{.design = Matrix(rows, 3), .y = {}};
  for (std::size_t r = 0; r < rows; ++r) {
    problem.design(r, 0) = 1.0;
    problem.design(r, 1) = random.normal();
    problem.design(r, 2) = random.normal();
    problem.y.push_back(2.0 - problem.design(r, 1) + 0.1 * random.normal());
  }
  return problem;
}

TEST(WeightedLeastSquares, WholeWeightsAreRepeatedRows) {
  const Problem problem = make_problem(12);
  std::vector<double> weights;
  std::vector<std::size_t> copies;
  for (std::size_t r = 0; r < 12; ++r) {
    weights.push_back(static_cast<double>(r % 4));  // zeros among them
    copies.insert(copies.end(), r % 4, r);
  }
  Matrix repeated(copies.size(), 3);
  std::vector<double> y;
  for (std::size_t k = 0; k < copies.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c) repeated(k, c) = problem.design(copies[k], c);
    y.push_back(problem.y[copies[k]]);
  }
  const WeightedFit fit = solve_weighted_least_squares(problem.design, problem.y, weights);
  const LeastSquaresFit expected = solve_least_squares(repeated, y);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(fit.coefficients[c], expected.coefficients[c], 1e-14);
    EXPECT_NEAR(fit.unscaled_covariance(c, c), expected.unscaled_covariance(c, c), 1e-14);
  }
  EXPECT_NEAR(fit.weighted_rss, expected.rss, 1e-14);
  for (std::size_t r = 0; r < 12; ++r) {
    double residual = problem.y[r];
    for (std::size_t c = 0; c < 3; ++c) residual -= problem.design(r, c) * fit.coefficients[c];
    EXPECT_NEAR(fit.residuals[r], residual, 1e-14);
  }
}

TEST(WeightedLeastSquares, RefusesWrongWeights) {
  const Problem problem = make_problem(5);
  const auto solve = [&](std::vector<double> weights) {
    (void)solve_weighted_least_squares(problem.design, problem.y, weights);
  };
  EXPECT_THROW(solve({1, 1, 1, 1}), std::invalid_argument);
  EXPECT_THROW(solve({1, 1, -1, 1, 1}), std::invalid_argument);
  EXPECT_THROW(solve({1, 1, std::numeric_limits<double>::quiet_NaN(), 1, 1}), std::invalid_argument);
  EXPECT_THROW(solve({1, 1, 0, 0, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace proofmass
