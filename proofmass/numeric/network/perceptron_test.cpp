// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/network/perceptron.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numeric>

#include "support/scalar_perceptron.hpp"

namespace proofmass {
namespace {

TEST(PerceptronShape, CountsThePaper36Weights) {
  constexpr PerceptronShape shape{.inputs = 3, .hidden = 7};
  EXPECT_EQ(shape.hidden_weights(), 28U);
  EXPECT_EQ(shape.output_weights(), 8U);
  EXPECT_EQ(shape.parameters(), 36U);
}

RC_GTEST_PROP(NguyenWidrow, MagnitudeAndEvenBiasesOfTheRule, (std::uint64_t seed)) {
  RandomStream random(seed);
  const PerceptronShape shape{.inputs = 1 + random.index(3), .hidden = 1 + random.index(25)};
  const std::vector<double> weights = nguyen_widrow(shape, random);
  RC_ASSERT(weights.size() == shape.hidden_weights());
  const auto hidden = static_cast<double>(shape.hidden);
  const double magnitude = 0.7 * std::pow(hidden, 1.0 / static_cast<double>(shape.inputs));
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    const auto w = std::span(weights).subspan(j * shape.inputs, shape.inputs);
    RC_ASSERT(std::abs(std::sqrt(std::inner_product(w.begin(), w.end(), w.begin(), 0.0)) - magnitude) <
              1e-13 * magnitude);
    const double spread = shape.hidden == 1 ? 0.0 : -1.0 + 2.0 * static_cast<double>(j) / (hidden - 1.0);
    const double bias = weights[shape.hidden * shape.inputs + j];
    RC_ASSERT(std::abs(bias - (w[0] < 0.0 ? -1.0 : 1.0) * magnitude * spread) < 1e-13 * magnitude);
  }
}

TEST(NguyenWidrow, DirectionsAreUniform) {
  RandomStream random(3);
  const PerceptronShape shape{.inputs = 3, .hidden = 1};
  double sums[3] = {};
  double squares[3] = {};
  constexpr int draws = 4000;
  for (int i = 0; i < draws; ++i) {
    const std::vector<double> weights = nguyen_widrow(shape, random);
    for (std::size_t k = 0; k < 3; ++k) {
      sums[k] += weights[k] / 0.7;
      squares[k] += std::pow(weights[k] / 0.7, 2);
    }
  }
  // A component of a uniform direction has mean 0 and variance 1/3, its square variance 4/45. The tolerance
  // is five standard deviations.
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(sums[k] / draws, 0.0, 5.0 * std::sqrt(1.0 / 3.0 / draws));
    EXPECT_NEAR(squares[k] / draws, 1.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / draws));
  }
}

TEST(RandomOutputLayer, FillsTheUnitInterval) {
  RandomStream random(4);
  const PerceptronShape shape{.inputs = 3, .hidden = 999};
  const std::vector<double> weights = random_output_layer(shape, random);
  ASSERT_EQ(weights.size(), 1000U);
  const auto [least, greatest] = std::minmax_element(weights.begin(), weights.end());
  EXPECT_GE(*least, -1.0);
  EXPECT_LE(*greatest, 1.0);
  EXPECT_LT(*least, -0.98);
  EXPECT_GT(*greatest, 0.98);
}

// The same function with the units in another order and some of their signs changed.
std::vector<double> disguised(const PerceptronShape& shape, const std::vector<double>& weights,
                              RandomStream& random) {
  std::vector<double> result = weights;
  const std::vector<std::size_t> order = random_permutation(shape.hidden, random);
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    const double sign = random.index(2) == 0 ? 1.0 : -1.0;
    const std::size_t from = order[j];
    for (std::size_t k = 0; k < shape.inputs; ++k) {
      result[j * shape.inputs + k] = sign * weights[from * shape.inputs + k];
    }
    result[shape.hidden * shape.inputs + j] = sign * weights[shape.hidden * shape.inputs + from];
    result[shape.hidden_weights() + j] = sign * weights[shape.hidden_weights() + from];
  }
  return result;
}

RC_GTEST_PROP(CanonicalWeights, AreTheSameForAllDisguisesOfOneFunction, (std::uint64_t seed)) {
  RandomStream random(seed);
  const PerceptronShape shape{.inputs = 1 + random.index(3), .hidden = 1 + random.index(9)};
  std::vector<double> weights = test::random_vector(shape.parameters(), random);
  if (shape.hidden > 1 && random.index(2) == 0) {
    // One unit appears twice, and one has no effect.
    std::copy_n(weights.begin(), shape.inputs, weights.begin() + static_cast<std::ptrdiff_t>(shape.inputs));
    weights[shape.hidden * shape.inputs + 1] = weights[shape.hidden * shape.inputs];
    weights[shape.hidden_weights() + shape.hidden - 1] = 0.0;
  }
  const std::vector<double> canonical = canonical_weights(shape, weights);
  RC_ASSERT(canonical_weights(shape, canonical) == canonical);
  for (int repeat = 0; repeat < 5; ++repeat) {
    RC_ASSERT(canonical_weights(shape, disguised(shape, weights, random)) == canonical);
  }
  for (std::size_t j = 0; j < shape.hidden; ++j) RC_ASSERT(canonical[shape.hidden_weights() + j] >= 0.0);
  const Samples samples = test::random_samples(shape.inputs, 5, random);
  for (std::size_t row = 0; row < 5; ++row) {
    const auto x = test::sample_inputs(samples, row);
    const test::Real difference =
        test::scalar_output(shape, canonical, x) - test::scalar_output(shape, weights, x);
    RC_ASSERT(std::abs(difference) < 1e-15L);
  }
}

}  // namespace
}  // namespace proofmass
