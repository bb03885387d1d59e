// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/network/perceptron_problem.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "support/scalar_perceptron.hpp"

namespace proofmass {
namespace {

// Sum of squares of target - output by the scalar network.
test::Real scalar_sum(const PerceptronShape& shape, const test::RealVector& weights, const Samples& samples) {
  test::Real sum = 0;
  for (std::size_t row = 0; row < samples.rows(); ++row) {
    const test::Real e =
        samples.target()[row] - test::scalar_output(shape, weights, test::sample_inputs(samples, row));
    sum += e * e;
  }
  return sum;
}

RC_GTEST_PROP(PerceptronProblem, GradientIsHalfTheSlopeOfTheSumOfSquares, (std::uint64_t seed)) {
  RandomStream random(seed);
  const PerceptronShape shape{.inputs = 1 + random.index(3), .hidden = 1 + random.index(6)};
  const Samples samples = test::random_samples(shape.inputs, 1 + random.index(40), random);
  const std::vector<double> weights = test::random_vector(shape.parameters(), random);
  PerceptronProblem problem(shape, samples);
  const double sum = problem.evaluate(weights);
  problem.accept();
  // The trial point must not change the current one.
  (void)problem.evaluate(std::vector<double>(shape.parameters(), 0.1));
  Matrix normal(shape.parameters(), shape.parameters());
  std::vector<double> gradient(shape.parameters());
  problem.linearise(normal, gradient);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    constexpr test::Real step = 1e-6L;
    test::RealVector ahead(weights.begin(), weights.end());
    test::RealVector behind = ahead;
    ahead[i] += step;
    behind[i] -= step;
    const test::Real slope =
        (scalar_sum(shape, ahead, samples) - scalar_sum(shape, behind, samples)) / (2 * step);
    RC_ASSERT(std::abs(2.0L * gradient[i] - slope) <= 1e-8L * (1.0L + std::sqrt(sum * normal(i, i))));
  }
}

TEST(PerceptronProblem, TrainsOnWhatANetworkMade) {
  RandomStream random(2);
  const PerceptronShape shape{.inputs = 2, .hidden = 2};
  Samples samples = test::random_samples(2, 150, random);
  const std::vector<double> truth = test::random_vector(shape.parameters(), random);
  for (std::size_t row = 0; row < samples.rows(); ++row) {
    samples.target()[row] =
        static_cast<double>(test::scalar_output(shape, truth, test::sample_inputs(samples, row)));
  }
  std::vector<double> start = truth;
  for (double& weight : start) weight += 0.1 * random.normal();
  PerceptronProblem problem(shape, samples);
  const auto result = minimise(problem, start, {.iterations = 300, .target = 1e-24});
  EXPECT_LE(result.sum_of_squares, 1e-24);
  const auto found = canonical_weights(shape, result.point);
  const auto expected = canonical_weights(shape, truth);
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9);
}

}  // namespace
}  // namespace proofmass
