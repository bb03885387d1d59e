// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/regression/orthogonal_distance.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "proofmass/numeric/parallel.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

// f = a exp(b x) is so curved that plain Gauss-Newton fails from a distant start.
class Exponential final : public Surface {
 public:
  [[nodiscard]] std::size_t inputs() const override { return 1; }
  [[nodiscard]] std::size_t parameters() const override { return 2; }
  void evaluate(std::span<const double> p, std::size_t rows, SurfaceBlock& block) const override {
    for (std::size_t r = 0; r < rows; ++r) {
      const double growth = std::exp(p[1] * block.x(r, 0));
      block.value[r] = p[0] * growth;
      block.by_input(r, 0) = p[0] * p[1] * growth;
      block.by_parameter(r, 0) = growth;
      block.by_parameter(r, 1) = p[0] * block.x(r, 0) * growth;
    }
  }
};

// f = a + b x + c x³, which turns twice.
class Cubic final : public Surface {
 public:
  [[nodiscard]] std::size_t inputs() const override { return 1; }
  [[nodiscard]] std::size_t parameters() const override { return 3; }
  void evaluate(std::span<const double> p, std::size_t rows, SurfaceBlock& block) const override {
    for (std::size_t r = 0; r < rows; ++r) {
      const double x = block.x(r, 0);
      block.value[r] = p[0] + p[1] * x + p[2] * x * x * x;
      block.by_input(r, 0) = p[1] + 3.0 * p[2] * x * x;
      block.by_parameter(r, 0) = 1.0;
      block.by_parameter(r, 1) = x;
      block.by_parameter(r, 2) = x * x * x;
    }
  }
};

constexpr std::array kCubic{-2.5, 8.0, -4.0};

struct Points {
  std::vector<double> x, y, sigma_x, sigma_y;
  [[nodiscard]] SurfaceObservations observed() const {
    return {.inputs = {x}, .input_sigma = {sigma_x}, .output = y, .output_sigma = sigma_y};
  }
};

Points noisy_exponential(std::size_t rows) {
  RandomStream random(2);
  Points points;
  points.sigma_x.assign(rows, 0.05);
  points.sigma_y.assign(rows, 0.1);
  for (std::size_t r = 0; r < rows; ++r) {
    const double x = random.uniform(0.0, 2.0);
    points.x.push_back(x + 0.05 * random.normal());
    points.y.push_back(1.5 * std::exp(0.8 * x) + 0.1 * random.normal());
  }
  return points;
}

// The sum of squares with each row's true input found separately, by bisection of the derivative.
double profile(const Points& points, double a, double b) {
  double sum = 0.0;
  for (std::size_t r = 0; r < points.x.size(); ++r) {
    const auto slope = [&](double x) {
      const double value = a * std::exp(b * x);
      return (x - points.x[r]) / (0.05 * 0.05) - (points.y[r] - value) * b * value / (0.1 * 0.1);
    };
    double low = points.x[r] - 0.5;
    double high = points.x[r] + 0.5;
    for (int k = 0; k < 60; ++k) (slope(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
    const double residual = (points.y[r] - a * std::exp(b * low)) / 0.1;
    sum += residual * residual + std::pow((low - points.x[r]) / 0.05, 2);
  }
  return sum;
}

TEST(OrthogonalDistance, FindsTheMinimumOfTheProfile) {
  const Points points = noisy_exponential(60);
  const auto fit = fit_orthogonal_distance(Exponential(), points.observed(), std::array{1.0, 1.0});
  EXPECT_EQ(fit.termination.cause, Cause::converged);
  const double a = fit.parameters[0];
  const double b = fit.parameters[1];
  const double least = profile(points, a, b);
  EXPECT_NEAR(fit.sum_of_squares, least, 1e-9 * least);
  for (const double h : {1e-4, -1e-4}) {
    EXPECT_GT(profile(points, a + h, b), least);
    EXPECT_GT(profile(points, a, b + h), least);
  }
  EXPECT_NEAR((profile(points, a + 1e-4, b) - profile(points, a - 1e-4, b)) / 2e-4, 0.0, 1e-4);
  EXPECT_NEAR(fit.sum_of_squares / static_cast<double>(fit.dof), 1.0, 0.5);
}

TEST(OrthogonalDistance, DampsFromAfarAndNeverGetsWorse) {
  const Points points = noisy_exponential(60);
  const auto near = fit_orthogonal_distance(Exponential(), points.observed(), std::array{1.4, 0.8});
  const auto far = fit_orthogonal_distance(Exponential(), points.observed(), std::array{0.2, 3.0});
  EXPECT_EQ(far.termination.cause, Cause::converged);
  EXPECT_NEAR(far.parameters[0], near.parameters[0], 1e-8);
  EXPECT_NEAR(far.parameters[1], near.parameters[1], 1e-8);
  for (std::size_t k = 1; k < far.history.size(); ++k) {
    EXPECT_LE(far.history[k], far.history[k - 1] * (1.0 + 1e-6));
  }
}

// The turning points lie about ±0.8, within three standard deviations of the input: there the linearisation
// of a row overshoots, and a row's offset has several local solutions.
Points noisy_cubic(std::uint64_t seed, double sigma) {
  RandomStream random(seed);
  Points points;
  points.sigma_x.assign(100, sigma);
  points.sigma_y.assign(100, 2.0);
  for (std::size_t r = 0; r < 100; ++r) {
    const double x = -5.0 + static_cast<double>(r) / 9.9;
    points.x.push_back(x + sigma * random.normal());
    points.y.push_back(kCubic[0] + kCubic[1] * x + kCubic[2] * x * x * x + 2.0 * random.normal());
  }
  return points;
}

TEST(OrthogonalDistance, ConvergesWhereTheSurfaceBendsWithinTheInputsUncertainty) {
  std::size_t apart = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const Points points = noisy_cubic(seed, 0.3);
    const auto off = fit_orthogonal_distance(Cubic(), points.observed(), std::array{0.0, 4.0, -3.5});
    const auto near = fit_orthogonal_distance(Cubic(), points.observed(), kCubic);
    EXPECT_EQ(off.termination.cause, Cause::converged);
    EXPECT_LT(off.iterations, 100U);
    if (std::abs(off.sum_of_squares - near.sum_of_squares) > 1e-8 * near.sum_of_squares) ++apart;
    for (std::size_t k = 1; k < off.history.size(); ++k) {
      EXPECT_LE(off.history[k], off.history[k - 1] * (1.0 + 1e-9));
    }
  }
  // Now and then the parameters too have two solutions; one row alone must not keep the fit from the better.
  EXPECT_LE(apart, 1U);
}

// Of the fit of a cubic with the parameters given: every row's offset at the best place near the fitted one,
// by ternary search.
double profile(const Points& points, const Matrix& offsets, std::span<const double> p) {
  double sum = 0.0;
  for (std::size_t r = 0; r < points.x.size(); ++r) {
    const auto cost = [&](double offset) {
      const double x = points.x[r] + offset;
      const double residual = (points.y[r] - p[0] - p[1] * x - p[2] * x * x * x) / points.sigma_y[r];
      return residual * residual + std::pow(offset / points.sigma_x[r], 2);
    };
    double low = offsets(r, 0) - 1e-2;
    double high = offsets(r, 0) + 1e-2;
    for (int k = 0; k < 80; ++k) {
      const double third = (high - low) / 3.0;
      if (cost(low + third) > cost(high - third)) {
        low += third;
      } else {
        high -= third;
      }
    }
    sum += cost(0.5 * (low + high));
  }
  return sum;
}

// Gauss-Newton creeps where the surface bends much: once the sum of squares stands still far below one
// standard error, that is convergence, and the reason says by how little.
TEST(OrthogonalDistance, AStandstillFarBelowOneStandardErrorIsConvergence) {
  std::size_t still = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Points points = noisy_cubic(seed, 0.5);
    const auto fit = fit_orthogonal_distance(Cubic(), points.observed(), kCubic);
    EXPECT_EQ(fit.termination.cause, Cause::converged);
    if (fit.termination.remarks.front().event != Event::distance_stands_still) continue;
    ++still;
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double h : {1e-2, -1e-2}) {
        std::vector<double> moved = fit.parameters;
        moved[k] += h * std::sqrt(fit.unscaled_covariance(k, k));
        EXPECT_GT(profile(points, fit.offsets, moved), fit.sum_of_squares) << seed << ' ' << k;
      }
    }
  }
  EXPECT_GT(still, 0U);
}

TEST(OrthogonalDistance, ThreadsChangeNothing) {
  const Points points = noisy_exponential(10'000);  // three chunks
  const auto with_threads = [&points](std::size_t threads) {
    const ThreadLimit limit(threads);
    return fit_orthogonal_distance(Exponential(), points.observed(), std::array{1.0, 1.0});
  };
  const auto one = with_threads(1);
  const auto three = with_threads(3);
  EXPECT_EQ(one.parameters, three.parameters);
  EXPECT_EQ(one.history, three.history);
}

TEST(OrthogonalDistance, ExactInputsAreLeftAlone) {
  Points points = noisy_exponential(40);
  points.sigma_x.assign(40, 0.0);
  points.sigma_x[7] = 0.05;
  const auto fit = fit_orthogonal_distance(Exponential(), points.observed(), std::array{1.4, 0.8});
  for (std::size_t r = 0; r < 40; ++r) EXPECT_EQ(fit.offsets(r, 0) == 0.0, r != 7) << r;
}

TEST(OrthogonalDistance, StopsWhenAskedAndAtTheLimit) {
  const Points points = noisy_exponential(40);
  const auto start = std::array{1.0, 1.0};
  const auto stopped = fit_orthogonal_distance(Exponential(), points.observed(), start, {},
                                               [](std::size_t iteration, double) { return iteration < 2; });
  EXPECT_EQ(stopped.termination.cause, Cause::stopped);
  EXPECT_EQ(stopped.iterations, 2U);
  const auto limited = fit_orthogonal_distance(Exponential(), points.observed(), start, {.iterations = 1});
  EXPECT_EQ(limited.termination.cause, Cause::iteration_limit);
}

TEST(OrthogonalDistance, RefusesWhatMakesNoSense) {
  Points points = noisy_exponential(40);
  points.sigma_y[3] = 0.0;
  const auto start = std::array{1.0, 1.0};
  EXPECT_THROW((void)fit_orthogonal_distance(Exponential(), points.observed(), start), std::invalid_argument);
  points = noisy_exponential(40);
  points.sigma_x.pop_back();
  EXPECT_THROW((void)fit_orthogonal_distance(Exponential(), points.observed(), start), std::invalid_argument);
  points = noisy_exponential(1);
  EXPECT_THROW((void)fit_orthogonal_distance(Exponential(), points.observed(), start), std::invalid_argument);
}

}  // namespace
}  // namespace proofmass
