// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/least_squares.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "proofmass/numeric/random.hpp"
#include "support/nist.hpp"

namespace proofmass {
namespace {

struct CertifiedSet {
  std::string name;
  bool intercept;
  int degree;     // powers of the first predictor; 0: every predictor as it is
  double digits;  // to be reached by the worst of coefficients and standard deviations
};

void PrintTo(const CertifiedSet& set, std::ostream* out) { *out << set.name; }

Matrix make_design(const test::NistProblem& problem, const CertifiedSet& set) {
  const std::size_t first = set.intercept ? 1 : 0;
  const std::size_t columns = set.degree > 0 ? static_cast<std::size_t>(set.degree) : problem.x.size();
  Matrix design(problem.y.size(), first + columns);
  for (std::size_t r = 0; r < design.rows(); ++r) {
    if (set.intercept) design(r, 0) = 1.0;
    for (std::size_t c = 0; c < columns; ++c) {
      design(r, first + c) =
          set.degree > 0 ? std::pow(problem.x[0][r], static_cast<double>(c + 1)) : problem.x[c][r];
    }
  }
  return design;
}

class NistLinear : public testing::TestWithParam<CertifiedSet> {};

TEST_P(NistLinear, ReachesTheCertifiedDigits) {
  const CertifiedSet& set = GetParam();
  const auto path = std::filesystem::path(PROOFMASS_REFERENCE_DATA) / "nist" / "linear" / (set.name + ".dat");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "reference data absent: " << path;
  const test::NistProblem problem = test::read_nist(path);
  const LeastSquaresFit fit = solve_least_squares(make_design(problem, set), problem.y);

  ASSERT_EQ(fit.coefficients.size(), problem.certified.size());
  double coefficient_digits = 15.0;
  double sd_digits = test::correct_digits(fit.residual_sd(), problem.residual_sd);
  for (std::size_t k = 0; k < problem.certified.size(); ++k) {
    const double sd = fit.residual_sd() * std::sqrt(fit.unscaled_covariance(k, k));
    coefficient_digits =
        std::min(coefficient_digits, test::correct_digits(fit.coefficients[k], problem.certified[k]));
    // Wampler 1 and 2 are exact polynomials with certified deviations of zero: digits are then those of the
    // absolute value, against coefficients of 1 and less.
    sd_digits = std::min(sd_digits, test::correct_digits(sd, problem.certified_sd[k]));
  }
  RecordProperty("coefficient_digits", fmt::format("{:.1f}", coefficient_digits));
  RecordProperty("standard_deviation_digits", fmt::format("{:.1f}", sd_digits));
  fmt::print("{:9} worst coefficient {:4.1f} digits, worst standard deviation {:4.1f}\n", set.name,
             coefficient_digits, sd_digits);
  EXPECT_GE(coefficient_digits, set.digits);
  EXPECT_GE(sd_digits, set.digits);
}

INSTANTIATE_TEST_SUITE_P(
    AllSets, NistLinear,
    testing::Values(CertifiedSet{"Filip", true, 10, 7.0}, CertifiedSet{"Longley", true, 0, 10.0},
                    CertifiedSet{"NoInt1", false, 1, 13.0}, CertifiedSet{"NoInt2", false, 1, 13.0},
                    CertifiedSet{"Norris", true, 1, 12.0}, CertifiedSet{"Pontius", true, 2, 12.0},
                    CertifiedSet{"Wampler1", true, 5, 9.5}, CertifiedSet{"Wampler2", true, 5, 9.5},
                    CertifiedSet{"Wampler3", true, 5, 9.5}, CertifiedSet{"Wampler4", true, 5, 7.5},
                    CertifiedSet{"Wampler5", true, 5, 5.5}),
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
