// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/normal_solution.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/linear/weighted_least_squares.hpp"
#include "proofmass/numeric/random.hpp"
#include "support/nist_linear.hpp"
#include "support/reference_data.hpp"

namespace proofmass {
namespace {

NormalSolution solve(const Matrix& design, const std::vector<double>& y) {
  const MatrixRows rows(design, y);
  return solve_normal_equations(gram_matrix(rows), rows);
}

double residual_sd(const NormalSolution& fit) { return std::sqrt(fit.rss / static_cast<double>(fit.dof)); }

class NistLinearByNormalEquations : public testing::TestWithParam<test::CertifiedSet> {};

TEST_P(NistLinearByNormalEquations, ReachesTheCertifiedDigits) {
  const test::CertifiedSet& set = GetParam();
  const auto path = test::reference_data("nist/linear/" + set.name + ".dat");
  if (!path) GTEST_SKIP() << test::kNoReferenceData;
  const test::NistProblem problem = test::read_nist(*path);
  const NormalSolution fit = solve(test::make_design(problem, set), problem.y);

  ASSERT_EQ(fit.coefficients.size(), problem.certified.size());
  const auto digits =
      test::certified_digits(problem, fit.coefficients, fit.unscaled_covariance, residual_sd(fit));
  RecordProperty("coefficient_digits", fmt::format("{:.1f}", digits.coefficients));
  RecordProperty("standard_deviation_digits", fmt::format("{:.1f}", digits.standard_deviations));
  fmt::print("{:9} worst coefficient {:4.1f} digits, worst standard deviation {:4.1f}\n", set.name,
             digits.coefficients, digits.standard_deviations);
  EXPECT_GE(digits.coefficients, set.digits);
  EXPECT_GE(digits.standard_deviations, set.digits);
}

INSTANTIATE_TEST_SUITE_P(AllSets, NistLinearByNormalEquations, testing::ValuesIn(test::certified_sets()),
                         [](const auto& set) { return set.param.name; });

struct Data {
  Matrix design;
  std::vector<double> y;
};

// Polynomials of a variable near 1: the condition gets worse with the degree.
Data polynomial_data(std::size_t rows, std::size_t columns, double noise, RandomStream& random) {
  Data data{.design = Matrix(rows, columns), .y = {}};
  for (std::size_t r = 0; r < rows; ++r) {
    const double x = random.uniform(0.5, 1.5);
    double power = 1.0;
    double y = noise * random.normal();
    for (std::size_t c = 0; c < columns; ++c) {
      data.design(r, c) = power;
      y += power;
      power *= x;
    }
    data.y.push_back(y);
  }
  return data;
}

void expect_agreement(const NormalSolution& fit, const LeastSquaresFit& expected, double tolerance) {
  EXPECT_EQ(fit.dof, expected.dof);
  EXPECT_NEAR(fit.rss, expected.rss, 1e-12 * expected.rss);
  for (std::size_t i = 0; i < expected.coefficients.size(); ++i) {
    const double error = std::sqrt(expected.unscaled_covariance(i, i));
    EXPECT_NEAR(fit.coefficients[i], expected.coefficients[i],
                1e-13 * std::abs(expected.coefficients[i]) + 1e-14 * error);
    for (std::size_t j = 0; j < expected.coefficients.size(); ++j) {
      EXPECT_NEAR(fit.unscaled_covariance(i, j), expected.unscaled_covariance(i, j),
                  tolerance * error * std::sqrt(expected.unscaled_covariance(j, j)));
    }
    EXPECT_EQ(std::isnan(fit.vif[i]), std::isnan(expected.vif[i]));
    if (std::isnan(fit.vif[i])) continue;
    EXPECT_NEAR(fit.vif[i], expected.vif[i], tolerance * expected.vif[i]);
  }
}

TEST(NormalSolution, AgreesWithHouseholderAsFarAsThatIsGood) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomStream random(seed);
    for (const std::size_t columns : {1U, 3U, 6U, 9U}) {
      const Data data = polynomial_data(300, columns, 1e-3, random);
      const double condition = analyse_rank(data.design).condition_scaled;
      expect_agreement(solve(data.design, data.y), solve_least_squares(data.design, data.y),
                       1e-13 * condition);
    }
  }
}

TEST(NormalSolution, RanksAndConditionsAreThoseOfTheDesign) {
  RandomStream random(21);
  Data data = polynomial_data(400, 7, 1.0, random);
  for (std::size_t r = 0; r < 400; ++r) {
    data.design(r, 3) = data.design(r, 1) - 2.0 * data.design(r, 2);  // dependent except for rounding
    data.design(r, 5) = data.design(r, 4) * (1.0 + 1e-10 * random.normal());
  }
  const RankAnalysis expected = analyse_rank(data.design);
  const RankAnalysis found = analyse_rank(gram_matrix(MatrixRows(data.design, data.y)));
  ASSERT_EQ(expected.rank, 6U);
  EXPECT_EQ(found.independent, expected.independent);
  EXPECT_NEAR(found.condition_raw, expected.condition_raw, 1e-5 * expected.condition_raw);
  EXPECT_NEAR(found.condition_scaled, expected.condition_scaled, 1e-5 * expected.condition_scaled);
  ASSERT_EQ(found.null_space.size(), 1U);
  for (std::size_t c = 0; c < 7; ++c) {
    EXPECT_NEAR(found.null_space[0][c], expected.null_space[0][c], 1e-12) << c;
  }
}

// A column skipped as dependent must not remove anything from later columns.
TEST(NormalSolution, RoundingOfADependentColumnSaysNothingOfLaterOnes) {
  RandomStream random(22);
  Matrix design(100, 4);
  for (std::size_t r = 0; r < 100; ++r) {
    const double rounding = random.normal();
    design(r, 0) = 1.0;
    design(r, 1) = random.normal();
    design(r, 2) = design(r, 1) + 0x1p-51 * rounding;
    design(r, 3) = rounding;
  }
  const std::vector<double> y(100, 1.0);
  EXPECT_EQ(analyse_rank(gram_matrix(MatrixRows(design, y))).independent,
            (std::vector<std::size_t>{0, 1, 3}));
}

TEST(NormalSolution, TellsTheResidualsOfAnExactFit) {
  RandomStream random(23);
  Data data = polynomial_data(500, 4, 0.0, random);
  const NormalSolution fit = solve(data.design, data.y);
  const LeastSquaresFit expected = solve_least_squares(data.design, data.y);
  EXPECT_LT(fit.rss,
            3.0 * expected.rss);  // only rounding: of the data there, of the coefficients here
  EXPECT_LT(fit.rss, 500.0 * 1e-30);
  for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(fit.coefficients[c], 1.0, 1e-12);
}

TEST(NormalSolution, ScalesWithTheColumnsBits) {
  RandomStream random(24);
  Data data = polynomial_data(40, 4, 1.0, random);
  const NormalSolution plain = solve(data.design, data.y);
  for (double& value : data.design.column(2)) value *= 0x1p200;
  const NormalSolution scaled = solve(data.design, data.y);
  EXPECT_EQ(plain.rss, scaled.rss);
  EXPECT_EQ(plain.coefficients[2], scaled.coefficients[2] * 0x1p200);
  EXPECT_EQ(plain.unscaled_covariance(2, 1), scaled.unscaled_covariance(2, 1) * 0x1p200);
  EXPECT_EQ(plain.vif[2], scaled.vif[2]);
}

TEST(NormalSolution, ResidualsAndLeveragesAreThoseOfEachRow) {
  RandomStream random(25);
  const Data data = polynomial_data(20'000, 5, 0.1, random);
  const MatrixRows rows(data.design, data.y);
  const NormalSolution fit = solve_normal_equations(gram_matrix(rows), rows);
  const LeastSquaresFit expected = solve_least_squares(data.design, data.y);
  const auto residuals = regression_residuals(rows, fit.coefficients);
  const auto leverages = regression_leverages(rows, fit.orthogonaliser);
  for (std::size_t r = 0; r < 20'000; r += 7) {
    EXPECT_NEAR(residuals[r], expected.residuals[r], 1e-13);
    EXPECT_NEAR(leverages[r], expected.leverage[r], 1e-10 * expected.leverage[r]);
  }
}

TEST(NormalSolution, WeightedRowsAgreeWithTheWeightedDesign) {
  RandomStream random(26);
  const Data data = polynomial_data(300, 4, 0.1, random);
  std::vector<double> weights(300);
  for (std::size_t r = 0; r < 300; ++r) weights[r] = r % 9 == 0 ? 0.0 : random.uniform(0.1, 4.0);
  const WeightedFit expected = solve_weighted_least_squares(data.design, data.y, weights);
  const WeightedFit fit = solve_weighted_least_squares(MatrixRows(data.design, data.y), weights);
  EXPECT_NEAR(fit.rss, expected.rss, 1e-12 * expected.rss);
  EXPECT_NEAR(fit.weighted_rss, expected.weighted_rss, 1e-12 * expected.weighted_rss);
  for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(fit.coefficients[c], expected.coefficients[c], 1e-12);
  for (std::size_t r = 0; r < 300; ++r) {
    EXPECT_NEAR(fit.residuals[r], expected.residuals[r], 1e-13);
    EXPECT_NEAR(fit.leverage[r], expected.leverage[r], 1e-12);
  }
}

TEST(NormalSolution, RefusesWhatItCannotSolve) {
  RandomStream random(27);
  Data data = polynomial_data(6, 3, 1.0, random);
  EXPECT_THROW((void)solve(Matrix(2, 3), {1.0, 2.0}), std::invalid_argument);
  for (std::size_t r = 0; r < 6; ++r) data.design(r, 2) = 3.0 * data.design(r, 1);
  EXPECT_THROW((void)solve(data.design, data.y), std::invalid_argument);
}

}  // namespace
}  // namespace proofmass
