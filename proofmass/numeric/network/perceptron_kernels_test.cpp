// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/network/perceptron_kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "support/instruction_sets.hpp"
#include "support/scalar_perceptron.hpp"

namespace proofmass {
namespace {

using test::Real;
using test::RealVector;

constexpr Real kTolerance = 1e-13L;
// Numbers of samples near whole vectors and whole blocks of rows.
constexpr std::size_t kRows[] = {1, 2, 7, 8, 9, 31, 32, 33, 255, 256, 257, 300};

class PerceptronKernels : public test::OnInstructionSet {};
INSTANTIATE_TEST_SUITE_P(InstructionSets, PerceptronKernels, testing::ValuesIn(test::instruction_sets()),
                         test::instruction_set_name);

PerceptronShape random_shape(RandomStream& random) {
  return {.inputs = 1 + random.index(3), .hidden = 1 + random.index(25)};
}

std::string describe(const PerceptronShape& shape, const Samples& samples) {
  return std::to_string(shape.inputs) + "-" + std::to_string(shape.hidden) + "-1, " +
         std::to_string(samples.rows()) + " rows";
}

// |c| + sum |v|: an upper bound of the output, to which rounding is relative.
Real output_bound(const PerceptronShape& shape, const std::vector<double>& weights) {
  Real bound = 0;
  for (std::size_t j = shape.hidden_weights(); j < shape.parameters(); ++j) bound += std::abs(weights[j]);
  return bound;
}

void expect_scalar_outputs(const PerceptronShape& shape, const std::vector<double>& weights,
                           const Samples& samples) {
  SCOPED_TRACE(describe(shape, samples));
  const Real bound = output_bound(shape, weights);
  std::vector<double> outputs(samples.rows());
  perceptron_outputs(shape, weights, samples, outputs);
  Real sum = 0;
  Real sum_bound = 0;
  for (std::size_t row = 0; row < samples.rows(); ++row) {
    const Real expected = test::scalar_output(shape, weights, test::sample_inputs(samples, row));
    ASSERT_LE(std::abs(outputs[row] - expected), kTolerance * bound) << "row " << row;
    const Real error = samples.target()[row] - expected;
    const Real error_bound = std::abs(Real{samples.target()[row]}) + bound;
    sum += error * error;
    sum_bound += error_bound * error_bound;
  }
  ASSERT_LE(std::abs(perceptron_sse(shape, weights, samples) - sum), kTolerance * sum_bound);
}

TEST_P(PerceptronKernels, OutputsAndSumOfSquaresAreThoseOfTheScalarNetwork) {
  RandomStream random(1);
  for (const std::size_t rows : kRows) {
    for (int repeat = 0; repeat < 4; ++repeat) {
      const PerceptronShape shape = random_shape(random);
      const Samples samples = test::random_samples(shape.inputs, rows, random);
      expect_scalar_outputs(shape, test::random_vector(shape.parameters(), random), samples);
    }
  }
}

TEST_P(PerceptronKernels, ExtremeWeightsGiveTheScalarOutputs) {
  RandomStream random(2);
  const PerceptronShape shape{.inputs = 3, .hidden = 5};
  Samples samples(3, 45);
  // Odd multiples of 1/16: three of them and a bias never cancel. With cancellation the argument would be
  // rounding.
  for (std::size_t k = 0; k < 3; ++k) {
    for (double& x : samples.input(k)) x = static_cast<double>(2 * random.index(16) + 1) / 16.0 - 1.0;
  }
  for (const double size : {1e3, 1e-300, 5e-324, 1e-310, 1e15, 1e300}) {
    std::vector<double> weights = test::random_vector(shape.parameters(), random);
    for (std::size_t i = 0; i < shape.hidden_weights(); ++i) weights[i] = weights[i] < 0.0 ? -size : size;
    expect_scalar_outputs(shape, weights, samples);
    for (std::size_t i = shape.hidden_weights(); i < shape.parameters(); ++i) {
      weights[i] *= size < 1.0 ? size : 1e3;
    }
    if (size > 1e-300) expect_scalar_outputs(shape, weights, samples);
  }
}

TEST_P(PerceptronKernels, TheLargestWeightsLeaveInputsOfZeroAndThePaddingAlone) {
  const PerceptronShape shape{.inputs = 1, .hidden = 1};
  Samples samples(1, 3);
  samples.input(0)[1] = -1.0;
  std::vector<double> outputs(3);
  perceptron_outputs(shape, std::vector{1.7e308, 0.0, 2.0, 0.5}, samples, outputs);
  EXPECT_EQ(outputs, (std::vector{0.5, -1.5, 0.5}));
  EXPECT_EQ(perceptron_sse(shape, std::vector{1.7e308, 0.0, 2.0, 0.5}, samples), 2.75);
}

TEST_P(PerceptronKernels, WeightsThatAreNotNumbersNeverGiveAFiniteSumOfSquares) {
  RandomStream random(3);
  const PerceptronShape shape{.inputs = 2, .hidden = 3};
  const std::vector<double> weights = test::random_vector(shape.parameters(), random);
  for (const std::size_t rows : {1U, 8U, 13U, 128U, 130U}) {
    const Samples samples = test::random_samples(shape.inputs, rows, random);
    Matrix jtj(shape.parameters(), shape.parameters());
    std::vector<double> jte(shape.parameters());
    for (std::size_t i = 0; i < weights.size(); ++i) {
      std::vector<double> poisoned = weights;
      poisoned[i] = std::numeric_limits<double>::quiet_NaN();
      EXPECT_FALSE(std::isfinite(perceptron_sse(shape, poisoned, samples))) << rows << " rows, weight " << i;
      PerceptronColumns columns(shape, samples);
      EXPECT_FALSE(
          std::isfinite(perceptron_normal_equations(shape, poisoned, samples, false, columns, jtj, jte)));
      EXPECT_FALSE(std::isfinite(perceptron_sse(shape, poisoned, samples, columns)));
      if (i < shape.hidden_weights()) continue;
      poisoned[i] = std::numeric_limits<double>::infinity();
      EXPECT_FALSE(std::isfinite(perceptron_sse(shape, poisoned, samples))) << rows << " rows, weight " << i;
    }
  }
}

TEST_P(PerceptronKernels, OutputOfARowDoesNotDependOnTheRowsAroundIt) {
  RandomStream random(4);
  const PerceptronShape shape{.inputs = 3, .hidden = 7};
  const std::vector<double> weights = test::random_vector(shape.parameters(), random);
  const Samples samples = test::random_samples(3, 133, random);
  std::vector<double> together(133);
  perceptron_outputs(shape, weights, samples, together);
  for (const std::size_t rows : {1U, 3U, 8U, 132U}) {
    for (std::size_t first = 0; first + rows <= 133; ++first) {
      Samples part(3, rows);
      for (std::size_t k = 0; k < 3; ++k) {
        std::copy_n(samples.input_data(k) + first, rows, part.input(k).begin());
      }
      std::vector<double> outputs(rows);
      perceptron_outputs(shape, weights, part, outputs);
      for (std::size_t row = 0; row < rows; ++row) ASSERT_EQ(outputs[row], together[first + row]);
    }
  }
}

// JᵀJ, Jᵀe and eᵀe as the last row and column of one matrix, with bounds for their elements: products of the
// lengths of columns in which tanh' is taken as 1, because rounding does not shrink where a unit saturates.
struct ScalarNormalEquations {
  std::vector<RealVector> products;
  RealVector lengths;
};

ScalarNormalEquations scalar_normal_equations(const PerceptronShape& shape,
                                              const std::vector<double>& weights, const Samples& samples) {
  const std::size_t p = shape.parameters();
  ScalarNormalEquations result{std::vector<RealVector>(p + 1, RealVector(p + 1)), RealVector(p + 1)};
  for (std::size_t row = 0; row < samples.rows(); ++row) {
    const RealVector x = test::sample_inputs(samples, row);
    RealVector line = test::scalar_gradient(shape, weights, x);
    line.push_back(samples.target()[row] - test::scalar_output(shape, weights, x));
    for (std::size_t c = 0; c <= p; ++c) {
      for (std::size_t r = 0; r <= p; ++r) result.products[c][r] += line[r] * line[c];
    }
    RealVector bounds(p + 1, 1);
    for (std::size_t j = 0; j < shape.hidden; ++j) {
      const Real v = std::abs(weights[shape.hidden_weights() + j]);
      for (std::size_t k = 0; k < shape.inputs; ++k) bounds[j * shape.inputs + k] = v * std::abs(x[k]);
      bounds[shape.hidden * shape.inputs + j] = v;
    }
    bounds[p] = std::abs(Real{samples.target()[row]}) + output_bound(shape, weights);
    for (std::size_t c = 0; c <= p; ++c) result.lengths[c] += bounds[c] * bounds[c];
  }
  for (Real& length : result.lengths) length = std::sqrt(length);
  return result;
}

void expect_scalar_normal_equations(const PerceptronShape& shape, const std::vector<double>& weights,
                                    const Samples& samples) {
  SCOPED_TRACE(describe(shape, samples));
  const std::size_t p = shape.parameters();
  const auto [expected, lengths] = scalar_normal_equations(shape, weights, samples);
  Matrix jtj(p, p);
  std::vector<double> jte(p);
  PerceptronColumns columns(shape, samples);
  const double sse = perceptron_normal_equations(shape, weights, samples, false, columns, jtj, jte);
  ASSERT_LE(std::abs(sse - expected[p][p]), kTolerance * lengths[p] * lengths[p]);
  for (std::size_t c = 0; c < p; ++c) {
    ASSERT_LE(std::abs(jte[c] - expected[c][p]), kTolerance * lengths[c] * lengths[p]) << c;
    for (std::size_t r = c; r < p; ++r) {
      ASSERT_LE(std::abs(jtj(r, c) - expected[r][c]), kTolerance * lengths[r] * lengths[c]) << r << ", " << c;
    }
  }
}

TEST_P(PerceptronKernels, NormalEquationsAreThoseOfTheExplicitJacobian) {
  RandomStream random(5);
  for (const std::size_t rows : kRows) {
    for (int repeat = 0; repeat < 2; ++repeat) {
      const PerceptronShape shape = random_shape(random);
      const Samples samples = test::random_samples(shape.inputs, rows, random);
      expect_scalar_normal_equations(shape, test::random_vector(shape.parameters(), random), samples);
    }
  }
}

TEST_P(PerceptronKernels, OutputsTakeTanhToRoundingOfOne) {
  RandomStream random(9);
  const PerceptronShape shape{.inputs = 1, .hidden = 1};
  const std::vector<double> weights{1.0, 0.0, 1.0, 0.0};
  Samples samples(1, 40000);
  for (std::size_t row = 0; row < 40000; ++row) {
    samples.input(0)[row] = row % 2 == 0
                                ? random.uniform(-4.0, 4.0)
                                : std::scalbn(random.uniform(-2.0, 2.0), -static_cast<int>(row / 40));
  }
  std::vector<double> outputs(40000);
  perceptron_outputs(shape, weights, samples, outputs);
  for (std::size_t row = 0; row < 40000; ++row) {
    const Real expected = std::tanh(Real{samples.input(0)[row]});
    const Real error = std::abs(outputs[row] - expected);
    ASSERT_LE(error, 4.5e-15L * std::abs(expected)) << samples.input(0)[row];
    ASSERT_LE(error, 4e-16L) << samples.input(0)[row];
  }
}

TEST_P(PerceptronKernels, NormalEquationsAreTheSameToTheBitOfColumnsKept) {
  RandomStream random(8);
  for (const std::size_t rows : {5U, 300U, 100000U}) {
    const PerceptronShape shape = random_shape(random);
    const Samples samples = test::random_samples(shape.inputs, rows, random);
    const std::size_t p = shape.parameters();
    PerceptronColumns columns(shape, samples);
    EXPECT_EQ(columns.hidden.keeps(), rows < 100000);
    for (int repeat = 0; repeat < 2; ++repeat) {
      const std::vector<double> weights = test::random_vector(p, random);
      PerceptronColumns fresh(shape, samples);
      Matrix jtj(p, p), again(p, p);
      std::vector<double> jte(p), jte_again(p);
      const double sum = perceptron_normal_equations(shape, weights, samples, false, fresh, jtj, jte);
      EXPECT_NEAR(perceptron_sse(shape, weights, samples, columns), sum, 1e-13 * sum);
      EXPECT_EQ(perceptron_normal_equations(shape, weights, samples, true, columns, again, jte_again), sum);
      EXPECT_EQ(jte, jte_again);
      EXPECT_TRUE(std::equal(jtj.data(), jtj.data() + p * p, again.data()));
    }
  }
}

TEST(ScalarPerceptron, GradientIsThatOfFiniteDifferences) {
  RandomStream random(6);
  for (int repeat = 0; repeat < 10; ++repeat) {
    const PerceptronShape shape = random_shape(random);
    const Samples samples = test::random_samples(shape.inputs, 1, random);
    const std::vector<double> weights = test::random_vector(shape.parameters(), random);
    const RealVector x = test::sample_inputs(samples, 0);
    const RealVector gradient = test::scalar_gradient(shape, weights, x);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      constexpr Real step = 1e-6L;
      RealVector ahead(weights.begin(), weights.end());
      RealVector behind = ahead;
      ahead[i] += step;
      behind[i] -= step;
      const Real difference = test::scalar_output(shape, ahead, x) - test::scalar_output(shape, behind, x);
      EXPECT_NEAR(static_cast<double>(gradient[i]), static_cast<double>(difference / (2 * step)), 1e-10);
    }
  }
}

TEST_P(PerceptronKernels, TanhIsRightToAFewUnitsInTheLastPlaceEverywhere) {
  RandomStream random(7);
  std::vector<double> arguments{0.0, 1e5, -1e5, 1e308, -1e308};
  for (int i = 0; i <= 100000; ++i) arguments.push_back(-25.0 + 50.0 * i / 100000.0);
  for (int i = 0; i < 20000; ++i) arguments.push_back(random.uniform(-1.0, 1.0));
  for (int exponent = -1074; exponent < 0; ++exponent) {
    for (int repeat = 0; repeat < 8; ++repeat) {
      arguments.push_back(std::scalbn(random.uniform(-2.0, 2.0), exponent));
    }
  }
  std::vector<double> values(arguments.size());
  tanh_of(arguments, values);
  Real worst = 0;
  double worst_argument = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Real expected = std::tanh(Real{arguments[i]});
    const auto rounded = std::abs(static_cast<double>(expected));
    const double ulp = std::nextafter(rounded, 2.0) - rounded;
    const Real error = std::abs(values[i] - expected) / ulp;
    ASSERT_LE(std::abs(values[i]), 1.0) << arguments[i];
    if (error > worst) std::tie(worst, worst_argument) = std::tuple(error, arguments[i]);
  }
  RecordProperty("worst_error_in_ulps", std::to_string(worst));
  EXPECT_LE(worst, 4.0L) << "at " << worst_argument;
}

}  // namespace
}  // namespace proofmass
