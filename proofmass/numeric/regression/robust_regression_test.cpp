// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/regression/robust_regression.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

constexpr std::array kKinds{LossKind::huber, LossKind::bisquare, LossKind::student};

struct Problem {
  Matrix design;
  std::vector<double> y;
};

// y = 1 + 2 x + Student noise of scale 0.1.
Problem make_line(std::size_t rows, std::uint64_t seed) {
  RandomStream random(seed);
  Problem problem{.design = Matrix(rows, 2), .y = {}};
  for (std::size_t r = 0; r < rows; ++r) {
    problem.design(r, 0) = 1.0;
    problem.design(r, 1) = random.uniform(-1.0, 1.0);
    problem.y.push_back(1.0 + 2.0 * problem.design(r, 1) + 0.1 * random.student_t(3.0));
  }
  return problem;
}

TEST(RobustLoss, SlopeIsTheDerivativeOfPsi) {
  for (const LossKind kind : kKinds) {
    const RobustLoss loss{.kind = kind, .tuning = default_tuning(kind)};
    const auto psi = [&loss](double u) { return loss.weight(u) * u; };
    for (const double u : {-6.0, -2.0, -0.3, 0.0, 0.7, 1.2, 3.1, 4.6, 9.0}) {
      constexpr double h = 1e-6;
      EXPECT_NEAR(loss.slope(u), (psi(u + h) - psi(u - h)) / (2.0 * h), 1e-9) << u;
    }
  }
}

TEST(RobustLoss, StudentMaximisesTheLikelihood) {
  RandomStream random(3);
  std::vector<double> draws;
  for (int k = 0; k < 3000; ++k) draws.push_back(0.2 * random.student_t(3.0));
  const StudentScale fit = fit_student(draws, 1.0);
  EXPECT_NEAR(fit.scale, 0.2, 0.015);
  EXPECT_NEAR(fit.dof, 3.0, 0.6);
  const auto likelihood = [&draws](double scale, double dof) {
    double sum = 0.0;
    for (const double r : draws) {
      sum += std::lgamma(0.5 * (dof + 1.0)) - std::lgamma(0.5 * dof) - 0.5 * std::log(dof) - std::log(scale) -
             0.5 * (dof + 1.0) * std::log1p(r * r / (scale * scale * dof));
    }
    return sum;
  };
  for (const double factor : {0.99, 1.01}) {
    EXPECT_LT(likelihood(factor * fit.scale, fit.dof), likelihood(fit.scale, fit.dof));
    EXPECT_LT(likelihood(fit.scale, factor * fit.dof), likelihood(fit.scale, fit.dof));
  }
}

TEST(RobustRegression, SolvesItsEstimatingEquations) {
  const Problem problem = make_line(200, 1);
  for (const LossKind kind : kKinds) {
    const RobustFit fit = fit_robustly(problem.design, problem.y, {.loss = kind});
    ASSERT_EQ(fit.termination.cause, Cause::converged);
    for (std::size_t c = 0; c < 2; ++c) {
      double sum = 0.0;
      for (std::size_t r = 0; r < 200; ++r) {
        const double u = fit.residuals[r] / fit.loss_scale;
        sum += fit.loss.weight(u) * u * problem.design(r, c);
      }
      EXPECT_NEAR(sum, 0.0, 1e-9);
    }
    EXPECT_NEAR(fit.coefficients[0], 1.0, 4.0 * std::sqrt(fit.covariance(0, 0)));
    EXPECT_NEAR(fit.coefficients[1], 2.0, 4.0 * std::sqrt(fit.covariance(1, 1)));
  }
}

TEST(RobustRegression, HugeConstantsGiveLeastSquares) {
  const Problem problem = make_line(50, 2);
  const LeastSquaresFit plain = solve_least_squares(problem.design, problem.y);
  for (const LossKind kind : {LossKind::huber, LossKind::bisquare}) {
    const RobustFit fit = fit_robustly(problem.design, problem.y, {.loss = kind, .tuning = 1e6});
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_NEAR(fit.coefficients[c], plain.coefficients[c], 1e-9);
      const double variance = plain.rss / static_cast<double>(plain.dof) * plain.unscaled_covariance(c, c);
      EXPECT_NEAR(fit.covariance(c, c), variance, 1e-8 * variance);
    }
  }
}

// One row in ten has an outlying x and a wrong y; the least-squares line follows these rows.
TEST(RobustRegression, BisquareWithstandsLeverage) {
  Problem problem = make_line(200, 3);
  for (std::size_t r = 0; r < 200; r += 10) {
    problem.design(r, 1) = 10.0;
    problem.y[r] = -20.0;
  }
  EXPECT_LT(solve_least_squares(problem.design, problem.y).coefficients[1], 0.0);
  const RobustFit fit = fit_robustly(problem.design, problem.y, {.loss = LossKind::bisquare});
  EXPECT_NEAR(fit.coefficients[1], 2.0, 0.1);
  for (std::size_t r = 0; r < 200; r += 10) EXPECT_EQ(fit.weights[r], 0.0);
}

// Brownlee's stack loss data (1965). Four of the 21 rows are outliers. Rows 1 and 3 have high leverage, and
// M-estimators do not detect them; rows 4 and 21 must be detected.
TEST(RobustRegression, FindsTheOutliersOfTheStackLossData) {
  constexpr std::array air{80., 80., 75., 62., 62., 62., 62., 62., 58., 58., 58.,
                           58., 58., 58., 50., 50., 50., 50., 50., 56., 70.};
  constexpr std::array water{27., 27., 25., 24., 22., 23., 24., 24., 23., 18., 18.,
                             17., 18., 19., 18., 18., 19., 19., 20., 20., 20.};
  constexpr std::array acid{89., 88., 90., 87., 87., 87., 93., 93., 87., 80., 89.,
                            88., 82., 93., 89., 86., 72., 79., 80., 82., 91.};
  constexpr std::array loss{42., 37., 37., 28., 18., 18., 19., 20., 15., 14., 14.,
                            13., 11., 12., 8.,  7.,  8.,  8.,  9.,  15., 15.};
  Matrix design(21, 4);
  for (std::size_t r = 0; r < 21; ++r) {
    design(r, 0) = 1.0;
    design(r, 1) = air[r];
    design(r, 2) = water[r];
    design(r, 3) = acid[r];
  }
  const RobustFit fit = fit_robustly(design, loss, {.loss = LossKind::bisquare});
  for (std::size_t row = 1; row <= 21; ++row) {
    if (row == 4 || row == 21) continue;
    EXPECT_GT(fit.weights[row - 1], fit.weights[3]) << row;
    EXPECT_GT(fit.weights[row - 1], fit.weights[20]) << row;
  }
  EXPECT_LT(fit.weights[20], 0.1);
}

}  // namespace
}  // namespace proofmass
