// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/least_squares.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>

#include "proofmass/numeric/random.hpp"
#include "support/nist_linear.hpp"
#include "support/reference_data.hpp"

namespace proofmass {
namespace {

class NistLinear : public testing::TestWithParam<test::CertifiedSet> {};

TEST_P(NistLinear, ReachesTheCertifiedDigits) {
  const test::CertifiedSet& set = GetParam();
  const auto path = test::reference_data("nist/linear/" + set.name + ".dat");
  if (!path) GTEST_SKIP() << test::kNoReferenceData;
  const test::NistProblem problem = test::read_nist(*path);
  const LeastSquaresFit fit = solve_least_squares(test::make_design(problem, set), problem.y);

  ASSERT_EQ(fit.coefficients.size(), problem.certified.size());
  const auto digits =
      test::certified_digits(problem, fit.coefficients, fit.unscaled_covariance, fit.residual_sd());
  RecordProperty("coefficient_digits", fmt::format("{:.1f}", digits.coefficients));
  RecordProperty("standard_deviation_digits", fmt::format("{:.1f}", digits.standard_deviations));
  fmt::print("{:9} worst coefficient {:4.1f} digits, worst standard deviation {:4.1f}\n", set.name,
             digits.coefficients, digits.standard_deviations);
  EXPECT_GE(digits.coefficients, set.digits);
  EXPECT_GE(digits.standard_deviations, set.digits);
}

INSTANTIATE_TEST_SUITE_P(AllSets, NistLinear, testing::ValuesIn(test::certified_sets()),
                         [](const auto& set) { return set.param.name; });

Matrix random_design(std::size_t rows, std::size_t columns, RandomStream& random) {
  Matrix design(rows, columns);
  for (std::size_t c = 0; c < columns; ++c) {
    for (double& value : design.column(c)) value = c == 0 ? 1.0 : random.normal();
  }
  return design;
}

std::vector<double> random_vector(std::size_t n, RandomStream& random) {
  std::vector<double> values(n);
  for (double& value : values) value = random.normal();
  return values;
}

RC_GTEST_PROP(LeastSquares, ScalesWithTheColumnsBits, (std::uint64_t seed)) {
  RandomStream random(seed);
  Matrix design = random_design(40, 5, random);
  const auto y = random_vector(40, random);
  const LeastSquaresFit plain = solve_least_squares(design, y);
  for (double& value : design.column(3)) value *= 0x1p70;
  const LeastSquaresFit scaled = solve_least_squares(design, y);
  RC_ASSERT(plain.residuals == scaled.residuals);
  RC_ASSERT(plain.coefficients[3] == scaled.coefficients[3] * 0x1p70);
  RC_ASSERT(plain.unscaled_covariance(3, 3) == scaled.unscaled_covariance(3, 3) * 0x1p140);
  RC_ASSERT(plain.vif[3] == scaled.vif[3]);
}

RC_GTEST_PROP(LeastSquares, LeverageIsTheProjection, (std::uint64_t seed)) {
  RandomStream random(seed);
  const Matrix design = random_design(30, 4, random);
  std::vector<double> unit(30, 0.0);
  unit[7] = 1.0;
  const LeastSquaresFit fit = solve_least_squares(design, unit);
  RC_ASSERT(std::abs((1.0 - fit.residuals[7]) - fit.leverage[7]) < 1e-13);
  double trace = 0.0;
  for (const double value : fit.leverage) trace += value;
  RC_ASSERT(std::abs(trace - 4.0) < 1e-12);
}

TEST(LeastSquares, VarianceInflationOfTwoCorrelatedColumns) {
  // Two predictors with sample correlation 3/5 have 1 / (1 - 9/25) whatever their means.
  Matrix design(4, 3);
  const double first[] = {11.0, 9.0, 11.0, 9.0};
  const double second[] = {5.0 + 1.4, 5.0 + 0.2, 5.0 - 0.2, 5.0 - 1.4};
  for (std::size_t r = 0; r < 4; ++r) {
    design(r, 0) = 1.0;
    design(r, 1) = first[r];
    design(r, 2) = second[r];
  }
  const LeastSquaresFit fit = solve_least_squares(design, std::vector<double>{1.0, 2.0, 4.0, 3.0});
  EXPECT_TRUE(std::isnan(fit.vif[0]));
  EXPECT_NEAR(fit.vif[1], 25.0 / 16.0, 1e-13);
  EXPECT_NEAR(fit.vif[2], 25.0 / 16.0, 1e-13);
}

TEST(LeastSquares, RefusesWhatItCannotSolve) {
  RandomStream random(1);
  Matrix design = random_design(6, 3, random);
  const auto y = random_vector(6, random);
  EXPECT_THROW((void)solve_least_squares(design, random_vector(5, random)), std::invalid_argument);
  EXPECT_THROW((void)solve_least_squares(Matrix(2, 3), random_vector(2, random)), std::invalid_argument);
  for (std::size_t r = 0; r < 6; ++r) design(r, 2) = 3.0 * design(r, 1);
  EXPECT_THROW((void)solve_least_squares(design, y), std::invalid_argument);
  design(2, 2) = std::nan("");
  EXPECT_THROW((void)solve_least_squares(design, y), std::invalid_argument);
}

}  // namespace
}  // namespace proofmass
