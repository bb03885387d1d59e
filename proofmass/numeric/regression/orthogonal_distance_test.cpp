// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/regression/orthogonal_distance.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

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
  EXPECT_EQ(fit.termination.cause, Cause::converged) << fit.termination.reason;
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
  EXPECT_EQ(far.termination.cause, Cause::converged) << far.termination.reason;
  EXPECT_NEAR(far.parameters[0], near.parameters[0], 1e-8);
  EXPECT_NEAR(far.parameters[1], near.parameters[1], 1e-8);
  for (std::size_t k = 1; k < far.history.size(); ++k) {
    EXPECT_LE(far.history[k], far.history[k - 1] * (1.0 + 1e-6));
  }
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
