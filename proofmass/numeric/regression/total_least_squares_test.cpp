// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/regression/total_least_squares.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

struct Line {
  Matrix design{25, 2};  // 1, x
  std::vector<double> y;
};

Line noisy_line(std::uint64_t seed) {
  RandomStream random(seed);
  Line line;
  for (std::size_t r = 0; r < line.design.rows(); ++r) {
    const double x = random.uniform(-3.0, 5.0);
    line.design(r, 0) = 1.0;
    line.design(r, 1) = x + 0.2 * random.normal();
    line.y.push_back(0.4 + 1.7 * x + 0.3 * random.normal());
  }
  return line;
}

// Slope and intercept in closed form (W. E. Deming, "Statistical Adjustment of Data", 1943).
std::array<double, 2> deming(const Line& line, double variance_ratio) {
  const auto n = static_cast<double>(line.y.size());
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t r = 0; r < line.y.size(); ++r) {
    x += line.design(r, 1) / n;
    y += line.y[r] / n;
  }
  for (std::size_t r = 0; r < line.y.size(); ++r) {
    xx += (line.design(r, 1) - x) * (line.design(r, 1) - x);
    xy += (line.design(r, 1) - x) * (line.y[r] - y);
    yy += (line.y[r] - y) * (line.y[r] - y);
  }
  const double difference = yy - variance_ratio * xx;
  const double slope =
      (difference + std::sqrt(difference * difference + 4.0 * variance_ratio * xy * xy)) / (2.0 * xy);
  return {y - slope * x, slope};
}

TEST(TotalLeastSquares, LineIsDemings) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Line line = noisy_line(seed);
    const auto expected = deming(line, 0.09 / 0.04);
    const auto fit = solve_total_least_squares(line.design, line.y, std::array{0.0, 0.2}, 0.3);
    EXPECT_NEAR(fit.coefficients[0], expected[0], 1e-13);
    EXPECT_NEAR(fit.coefficients[1], expected[1], 1e-13);
    EXPECT_GT(fit.gap, 5.0);
  }
}

TEST(TotalLeastSquares, OrderOfColumnsDoesNotMatter) {
  const Line line = noisy_line(3);
  Matrix swapped(line.design.rows(), 2);
  for (std::size_t r = 0; r < swapped.rows(); ++r) {
    swapped(r, 0) = line.design(r, 1);
    swapped(r, 1) = 1.0;
  }
  const auto fit = solve_total_least_squares(line.design, line.y, std::array{0.0, 0.2}, 0.3);
  const auto other = solve_total_least_squares(swapped, line.y, std::array{0.2, 0.0}, 0.3);
  EXPECT_NEAR(other.coefficients[1], fit.coefficients[0], 1e-14);
  EXPECT_NEAR(other.coefficients[0], fit.coefficients[1], 1e-14);
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_NEAR(other.unscaled_covariance(1 - i, 1 - j), fit.unscaled_covariance(i, j), 1e-14);
    }
  }
}

// With columns that are almost exact, estimate and covariance equal those of least squares.
TEST(TotalLeastSquares, TendsToLeastSquares) {
  const Line line = noisy_line(4);
  const auto fit = solve_total_least_squares(line.design, line.y, std::array{0.0, 1e-9}, 0.3);
  const auto reference = solve_least_squares(line.design, line.y);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(fit.coefficients[k], reference.coefficients[k], 1e-12);
    EXPECT_NEAR(fit.unscaled_covariance(k, k), 0.09 * reference.unscaled_covariance(k, k), 1e-12);
  }
  EXPECT_NEAR(fit.variance_ratio() * 0.09, reference.rss / 23.0, 1e-12);
}

TEST(TotalLeastSquares, RefusesWhatMakesNoSense) {
  const Line line = noisy_line(1);
  const auto solve = [&line](std::array<double, 2> sigma, double y_sigma) {
    return solve_total_least_squares(line.design, line.y, sigma, y_sigma);
  };
  EXPECT_THROW((void)solve({0.0, 0.0}, 0.3), std::invalid_argument);
  EXPECT_THROW((void)solve({0.0, -0.2}, 0.3), std::invalid_argument);
  EXPECT_THROW((void)solve({0.0, std::numeric_limits<double>::quiet_NaN()}, 0.3), std::invalid_argument);
  EXPECT_THROW((void)solve({0.0, 0.2}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace proofmass
