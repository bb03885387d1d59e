// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/deletion_residuals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "proofmass/numeric/linear/weighted_least_squares.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

struct GroupedProblem {
  Matrix design{60, 4};
  std::vector<double> y = std::vector<double>(60);
  std::vector<double> weights = std::vector<double>(60, 1.0);
  std::vector<std::size_t> group = std::vector<std::size_t>(60);
};

// A cubic in x, in seven groups of different sizes.
GroupedProblem make_grouped_problem(bool weighted) {
  RandomStream random(4, stream_id("deletion"));
  GroupedProblem problem;
  for (std::size_t row = 0; row < 60; ++row) {
    const double x = random.uniform(-1.0, 1.0);
    for (std::size_t c = 0; c < 4; ++c) problem.design(row, c) = std::pow(x, c);
    problem.y[row] = 1.0 + x + 0.1 * random.normal();
    if (weighted) problem.weights[row] = random.uniform(0.1, 3.0);
    problem.group[row] = random.index(7);
  }
  return problem;
}

std::vector<double> fitted(const GroupedProblem& problem, const std::vector<double>& weights) {
  return solve_weighted_least_squares(problem.design, problem.y, weights).coefficients;
}

double residual(const GroupedProblem& problem, const std::vector<double>& coefficients, std::size_t row) {
  double r = problem.y[row];
  for (std::size_t c = 0; c < 4; ++c) r -= problem.design(row, c) * coefficients[c];
  return r;
}

// Of each row, by a fit in which it and its group have no weight.
std::vector<double> refitted(const GroupedProblem& problem, const std::vector<std::size_t>& group) {
  std::vector<double> residuals;
  for (std::size_t row = 0; row < 60; ++row) {
    std::vector<double> others = problem.weights;
    for (std::size_t k = 0; k < 60; ++k) {
      if (group[k] == group[row]) others[k] = 0.0;
    }
    residuals.push_back(residual(problem, fitted(problem, others), row));
  }
  return residuals;
}

std::vector<double> residuals_of(const GroupedProblem& problem) {
  const std::vector<double> coefficients = fitted(problem, problem.weights);
  std::vector<double> residuals;
  for (std::size_t row = 0; row < 60; ++row) residuals.push_back(residual(problem, coefficients, row));
  return residuals;
}

class DeletionResidualsOf : public testing::TestWithParam<bool> {};

TEST_P(DeletionResidualsOf, AreThoseOfFitsWithoutTheRows) {
  const GroupedProblem problem = make_grouped_problem(GetParam());
  const MatrixRows rows(problem.design, problem.y);
  const std::span<const double> weights =
      GetParam() ? std::span<const double>(problem.weights) : std::span<const double>();
  std::vector<std::size_t> alone(60);
  std::iota(alone.begin(), alone.end(), std::size_t{0});
  const auto each = deletion_residuals(rows, residuals_of(problem), weights);
  const auto by_group = deletion_residuals(rows, residuals_of(problem), weights, problem.group, 7);
  const auto by_row = deletion_residuals(rows, residuals_of(problem), weights, alone, 60);
  const std::vector<double> each_expected = refitted(problem, alone);
  const std::vector<double> group_expected = refitted(problem, problem.group);
  for (std::size_t row = 0; row < 60; ++row) {
    EXPECT_NEAR(each.residuals[row], each_expected[row], 1e-12) << row;
    EXPECT_NEAR(by_row.residuals[row], each_expected[row], 1e-12) << row;
    EXPECT_NEAR(by_group.residuals[row], group_expected[row], 1e-12) << row;
  }
  EXPECT_EQ(each.undetermined + by_group.undetermined + by_row.undetermined, 0U);
}

INSTANTIATE_TEST_SUITE_P(Weights, DeletionResidualsOf, testing::Bool());

TEST(DeletionResiduals, AreAbsentWhereTheOthersDetermineNothing) {
  GroupedProblem problem = make_grouped_problem(false);
  for (std::size_t row = 0; row < 60; ++row)
    problem.design(row, 3) = problem.group[row] == 2 ? problem.design(row, 1) : 0.0;
  const MatrixRows rows(problem.design, problem.y);
  const auto deleted = deletion_residuals(rows, residuals_of(problem), {}, problem.group, 7);
  EXPECT_EQ(deleted.undetermined, 1U);
  for (std::size_t row = 0; row < 60; ++row)
    EXPECT_EQ(std::isnan(deleted.residuals[row]), problem.group[row] == 2) << row;
}

}  // namespace
}  // namespace proofmass
