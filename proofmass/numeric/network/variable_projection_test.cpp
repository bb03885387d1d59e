// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/network/variable_projection.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "proofmass/numeric/linear/least_squares.hpp"
#include "support/scalar_perceptron.hpp"

namespace proofmass {
namespace {

using Vector = std::vector<double>;

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Activations of the first `units` units by the scalar network, and ones.
Matrix activations(const PerceptronShape& shape, const Vector& hidden_weights, const Samples& samples,
                   std::size_t units) {
  Matrix phi(samples.rows(), units + 1);
  for (std::size_t row = 0; row < samples.rows(); ++row) {
    const auto x = test::sample_inputs(samples, row);
    for (std::size_t j = 0; j < units; ++j) {
      phi(row, j) = static_cast<double>(test::scalar_activation(shape, hidden_weights, j, x));
    }
    phi(row, units) = 1.0;
  }
  return phi;
}

LeastSquaresFit reference_fit(const PerceptronShape& shape, const Vector& hidden_weights,
                              const Samples& samples) {
  return solve_least_squares(activations(shape, hidden_weights, samples, shape.hidden), samples.target());
}

Vector moved(Vector point, double step, const Vector& direction) {
  for (std::size_t i = 0; i < point.size(); ++i) point[i] += step * direction[i];
  return point;
}

// A network that the samples determine, started by Nguyen and Widrow.
struct Case {
  explicit Case(std::uint64_t seed, std::size_t rows = 0)
      : random(seed),
        shape{.inputs = 1 + random.index(3), .hidden = 1 + random.index(5)},
        samples(test::random_samples(shape.inputs, rows > 0 ? rows : 30 + random.index(200), random)),
        weights(nguyen_widrow(shape, random)) {}
  RandomStream random;
  PerceptronShape shape;
  Samples samples;
  Vector weights;
};

RC_GTEST_PROP(SeparablePerceptron, SumOfSquaresIsThatOfLeastSquaresOnTheActivations, (std::uint64_t seed)) {
  const Case c(seed);
  SeparablePerceptron problem(c.shape, c.samples);
  const double sum = problem.evaluate(c.weights);
  const LeastSquaresFit fit = reference_fit(c.shape, c.weights, c.samples);
  RC_ASSERT(std::abs(sum - fit.rss) <= 1e-11 * fit.rss);

  Vector all = c.weights;
  all.insert(all.end(), problem.output_weights().begin(), problem.output_weights().end());
  RC_ASSERT(std::abs(perceptron_sse(c.shape, all, c.samples) - sum) <= 1e-11 * sum);
}

RC_GTEST_PROP(SeparablePerceptron, EstimatesToFourDigits, (std::uint64_t seed)) {
  const Case c(seed);
  SeparablePerceptron problem(c.shape, c.samples);
  const double rss = reference_fit(c.shape, c.weights, c.samples).rss;
  RC_ASSERT(std::abs(problem.estimate(c.weights) - rss) <= 1e-4 * rss);
}

RC_GTEST_PROP(SeparablePerceptron, StaysExactFromAnyCurrentPoint, (std::uint64_t seed)) {
  Case c(seed);
  SeparablePerceptron problem(c.shape, c.samples);
  Vector point = c.weights;
  // Each evaluation starts from the current point's factors; here that point is far away.
  for (int step = 0; step < 4; ++step) {
    (void)problem.evaluate(point);
    problem.accept();
    point = nguyen_widrow(c.shape, c.random);
    const double rss = reference_fit(c.shape, point, c.samples).rss;
    RC_ASSERT(std::abs(problem.evaluate(point) - rss) <= 1e-11 * rss);
  }
}

// The columns of -(I - Q Qᵀ) D (Kaufman's Jacobian), as residuals of least squares.
Matrix kaufman_jacobian(const Case& c, const Vector& output_weights) {
  const Matrix phi = activations(c.shape, c.weights, c.samples, c.shape.hidden);
  Matrix jacobian(c.samples.rows(), c.shape.hidden_weights());
  for (std::size_t row = 0; row < c.samples.rows(); ++row) {
    const auto gradient =
        test::scalar_hidden_gradient(c.shape, c.weights, output_weights, test::sample_inputs(c.samples, row));
    for (std::size_t i = 0; i < gradient.size(); ++i) jacobian(row, i) = static_cast<double>(gradient[i]);
  }
  for (std::size_t i = 0; i < jacobian.columns(); ++i) {
    const Vector projected = solve_least_squares(phi, jacobian.column(i)).residuals;
    std::transform(projected.begin(), projected.end(), jacobian.column(i).begin(), std::negate<>());
  }
  return jacobian;
}

// The largest error of linearise at the case's weights: that of the normal equations relative to the longest
// column of the Jacobian, that of the gradient relative to this and the residual.
struct LinearisationErrors {
  double normal = 0.0, gradient = 0.0;
};

LinearisationErrors linearisation_errors(const Case& c) {
  const std::size_t p = c.shape.hidden_weights();
  SeparablePerceptron problem(c.shape, c.samples);
  (void)problem.evaluate(c.weights);
  problem.accept();
  const Vector output_weights = problem.output_weights();
  (void)problem.evaluate(moved(c.weights, 0.1, c.weights));
  Matrix normal(p, p);
  Vector gradient(p);
  problem.linearise(normal, gradient);
  const Matrix jacobian = kaufman_jacobian(c, output_weights);
  const LeastSquaresFit fit = reference_fit(c.shape, c.weights, c.samples);
  double size = 0.0;
  for (std::size_t i = 0; i < p; ++i) size = std::max(size, dot(jacobian.column(i), jacobian.column(i)));
  LinearisationErrors errors;
  for (std::size_t i = 0; i < p; ++i) {
    const double error = std::abs(gradient[i] - dot(jacobian.column(i), fit.residuals));
    errors.gradient = std::max(errors.gradient, error / std::sqrt(size * fit.rss));
    for (std::size_t k = i; k < p; ++k) {
      const double expected = dot(jacobian.column(k), jacobian.column(i));
      errors.normal = std::max(errors.normal, std::abs(normal(k, i) - expected) / size);
    }
  }
  return errors;
}

RC_GTEST_PROP(SeparablePerceptron, LinearisesByKaufmansJacobian, (std::uint64_t seed)) {
  const LinearisationErrors errors = linearisation_errors(Case(seed));
  RC_ASSERT(errors.gradient <= 1e-9);
  RC_ASSERT(errors.normal <= 1e-9);
}

RC_GTEST_PROP(SeparablePerceptron, GradientIsHalfTheSlopeOfTheSumOfSquares, (std::uint64_t seed)) {
  Case c(seed);
  const std::size_t p = c.shape.hidden_weights();
  SeparablePerceptron problem(c.shape, c.samples);
  (void)problem.evaluate(c.weights);
  problem.accept();
  Matrix normal(p, p);
  Vector gradient(p);
  problem.linearise(normal, gradient);
  double length = 0.0;
  for (const double g : gradient) length = std::hypot(length, g);
  for (std::size_t i = 0; i < p; ++i) {
    Vector unit(p, 0.0);
    unit[i] = 1.0;
    constexpr double step = 1e-4;
    // Central differences of fourth order.
    const double near =
        problem.evaluate(moved(c.weights, step, unit)) - problem.evaluate(moved(c.weights, -step, unit));
    const double far = problem.evaluate(moved(c.weights, 2.0 * step, unit)) -
                       problem.evaluate(moved(c.weights, -2.0 * step, unit));
    const double slope = (8.0 * near - far) / (12.0 * step);
    RC_ASSERT(std::abs(2.0 * gradient[i] - slope) <= 1e-5 * length);
  }
}

// The largest error of curvature at the case's weights, relative to the lengths of the column and of the
// second derivative.
double curvature_error(Case& c, SeparablePerceptron& problem) {
  const std::size_t p = c.shape.hidden_weights();
  (void)problem.evaluate(c.weights);
  problem.accept();
  Matrix normal(p, p);
  Vector gradient(p), result(p);
  problem.linearise(normal, gradient);
  // so short that the third derivative hardly affects the step within the kernel
  Vector direction = test::random_vector(p, c.random);
  for (double& d : direction) d *= 1e-3;
  if (!problem.curvature(direction, result)) return std::numeric_limits<double>::infinity();

  const Matrix jacobian = kaufman_jacobian(c, problem.output_weights());
  const Vector ahead = reference_fit(c.shape, moved(c.weights, 1.0, direction), c.samples).residuals;
  const Vector here = reference_fit(c.shape, c.weights, c.samples).residuals;
  const Vector behind = reference_fit(c.shape, moved(c.weights, -1.0, direction), c.samples).residuals;
  Vector second(here.size());
  for (std::size_t row = 0; row < here.size(); ++row) {
    second[row] = ahead[row] - 2.0 * here[row] + behind[row];
  }
  double error = 0.0;
  for (std::size_t i = 0; i < p; ++i) {
    const auto column = jacobian.column(i);
    const double size = std::sqrt(dot(column, column) * dot(second, second));
    error = std::max(error, std::abs(result[i] - dot(column, second)) / size);
  }
  return error;
}

RC_GTEST_PROP(SeparablePerceptron, CurvatureIsThatOfTheResidualsAlongTheDirection, (std::uint64_t seed)) {
  Case c(seed);
  SeparablePerceptron problem(c.shape, c.samples);
  RC_ASSERT(curvature_error(c, problem) <= 1e-2);
  const Vector nowhere(c.weights.size(), std::numeric_limits<double>::quiet_NaN());
  Vector result(c.weights.size(), 0.0);
  RC_ASSERT(!problem.curvature(nowhere, result));
}

// More samples than can keep their columns, so that a pilot predicts the first pass.
Case many_samples(std::uint64_t seed) {
  Case c(seed, 40960);
  c.shape = {.inputs = c.shape.inputs, .hidden = 4};
  c.weights = nguyen_widrow(c.shape, c.random);
  return c;
}

void expect_exact(Case& c) {
  SeparablePerceptron problem(c.shape, c.samples);
  const double rss = reference_fit(c.shape, c.weights, c.samples).rss;
  EXPECT_NEAR(problem.evaluate(c.weights), rss, 1e-11 * rss);
  EXPECT_NEAR(problem.estimate(c.weights), rss, 1e-4 * rss);
  const LinearisationErrors errors = linearisation_errors(c);
  EXPECT_LE(errors.gradient, 1e-12);
  EXPECT_LE(errors.normal, 1e-12);
  EXPECT_LE(curvature_error(c, problem), 1e-2);
}

TEST(SeparablePerceptron, IsExactOnManySamples) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    Case c = many_samples(seed);
    expect_exact(c);
  }
}

// All pilot rows come from one corner.
TEST(SeparablePerceptron, IsExactWhereSomeSamplesTellLittleOfTheOthers) {
  Case c = many_samples(4);
  ColumnBlock numbers(1, c.samples.padded_rows());
  for (std::size_t row = 0; row < c.samples.rows(); ++row) numbers.column(0)[row] = static_cast<double>(row);
  const SampleRows some = one_of_each_stretch(c.samples, numbers, 4096);
  for (std::size_t i = 0; i < some.samples.rows(); ++i) {
    const auto row = static_cast<std::size_t>(some.fixed.column(0)[i]);
    for (std::size_t k = 0; k < c.shape.inputs; ++k) c.samples.input(k)[row] = 0.3 + 0.1 * c.random.normal();
  }
  expect_exact(c);
}

// Makes the last unit of a network useless. The best fit left is the one without it, or with it where it is
// independent of the others.
RC_GTEST_PROP(SeparablePerceptron, DegenerateUnitsNeverGiveLessThanTheTrueMinimum, (std::uint64_t seed)) {
  RandomStream random(seed);
  const PerceptronShape shape{.inputs = 2, .hidden = 3 + random.index(3)};
  const Samples samples = test::random_samples(2, 60, random);
  Vector weights = nguyen_widrow(shape, random);
  const std::size_t last = shape.hidden - 1;
  const auto copy_first_unit = [&](double sign) {
    for (std::size_t k = 0; k < 2; ++k) weights[last * 2 + k] = sign * weights[k];
    weights[shape.hidden * 2 + last] = sign * weights[shape.hidden * 2];
  };
  const auto constant_unit = [&](double w, double b) {
    weights[last * 2] = weights[last * 2 + 1] = w;
    weights[shape.hidden * 2 + last] = b;
  };
  SeparablePerceptron problem(shape, samples);
  for (const int spoil : {0, 1, 2, 3, 4, 5}) {
    if (spoil == 0) copy_first_unit(1.0);
    if (spoil == 1) copy_first_unit(-1.0);
    if (spoil == 2) constant_unit(0.0, 0.0);
    if (spoil == 3) constant_unit(0.0, 0.7);
    if (spoil == 4) constant_unit(0.0, 1e9);
    if (spoil == 5) constant_unit(1.0, -1e300);
    const double rss = solve_least_squares(activations(shape, weights, samples, last), samples.target()).rss;
    const double sum = problem.evaluate(weights);
    RC_ASSERT(sum >= rss * (1.0 - 1e-9));
    RC_ASSERT(sum <= rss * (1.0 + 1e-6));
    if (random.index(2) == 0) problem.accept();
  }
}

RC_GTEST_PROP(SeparablePerceptron, NearlyEqualUnitsNeverGiveLessThanTheTrueMinimum, (std::uint64_t seed)) {
  RandomStream random(seed);
  const PerceptronShape shape{.inputs = 2, .hidden = 4};
  const Samples samples = test::random_samples(2, 60, random);
  SeparablePerceptron problem(shape, samples);
  for (const double distance : {1e-2, 1e-4, 1e-6, 1e-7}) {
    Vector weights = nguyen_widrow(shape, random);
    for (std::size_t k = 0; k < 2; ++k) weights[6 + k] = weights[k] + distance * random.normal();
    weights[11] = weights[8] + distance * random.normal();
    const double rss = reference_fit(shape, weights, samples).rss;
    const double sum = problem.evaluate(weights);
    // The double nearest to an activation is off by 1e-16, and here the difference of two units matters.
    RC_ASSERT(sum >= rss * (1.0 - 1e-13 / distance));
    RC_ASSERT(sum <= rss * (1.0 + 1e-11 / distance));
  }
}

TEST(SeparablePerceptron, SaturatedUnitsFitNoBetterThanTheirSteps) {
  // With weights this large every unit is a step between neighbours of the sorted inputs.
  RandomStream random(8);
  const PerceptronShape shape{.inputs = 1, .hidden = 3};
  const Samples samples = test::random_samples(1, 40, random);
  SeparablePerceptron problem(shape, samples);
  for (const double size : {1e6, 1e100, 1e300}) {
    const Vector weights{size, size, -size, 0.3 * size, -0.2 * size, 0.5 * size};
    const double rss = reference_fit(shape, weights, samples).rss;
    EXPECT_NEAR(problem.evaluate(weights), rss, 1e-10 * rss) << size;
  }
}

TEST(SeparablePerceptron, NotANumberNeverLooksLikeAGoodFit) {
  Case c(9, 37);
  SeparablePerceptron problem(c.shape, c.samples);
  const double sum = problem.evaluate(c.weights);
  problem.accept();
  for (std::size_t i = 0; i < c.weights.size(); ++i) {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      Vector weights = c.weights;
      weights[i] = bad;
      const double value = problem.evaluate(weights);
      EXPECT_FALSE(value < sum * 1e-3) << "weight " << i;
      EXPECT_FALSE(std::isnan(bad) && std::isfinite(value)) << "weight " << i;
    }
  }
  // A point that was not accepted must leave no trace.
  SeparablePerceptron other(c.shape, c.samples);
  (void)other.evaluate(c.weights);
  other.accept();
  EXPECT_EQ(problem.evaluate(c.weights), other.evaluate(c.weights));
}

TEST(SeparablePerceptron, TrainsToRoundingOnWhatANetworkMade) {
  RandomStream random(10);
  const PerceptronShape shape{.inputs = 2, .hidden = 3};
  Samples samples = test::random_samples(2, 200, random);
  const Vector truth = test::random_vector(shape.parameters(), random);
  for (std::size_t row = 0; row < samples.rows(); ++row) {
    samples.target()[row] =
        static_cast<double>(test::scalar_output(shape, truth, test::sample_inputs(samples, row)));
  }
  for (const bool geodesic : {false, true}) {
    Vector start(truth.begin(), truth.begin() + static_cast<std::ptrdiff_t>(shape.hidden_weights()));
    for (double& weight : start) weight += 0.1 * random.normal();
    SeparablePerceptron problem(shape, samples);
    const auto result =
        minimise(problem, start, {.iterations = 400, .geodesic_acceleration = geodesic, .target = 1e-20});
    EXPECT_GT(result.history.front(), 1e-6);
    EXPECT_LE(result.sum_of_squares, 1e-20);
    Vector all = result.point;
    (void)problem.evaluate(result.point);
    all.insert(all.end(), problem.output_weights().begin(), problem.output_weights().end());
    EXPECT_LE(perceptron_sse(shape, all, samples), 2e-20);
  }
}

}  // namespace
}  // namespace proofmass
