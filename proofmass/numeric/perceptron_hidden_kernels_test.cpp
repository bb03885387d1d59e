// SPDX-License-Identifier: Apache-2.0
// The kernels of variable projection against plain dense algebra in extended precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "proofmass/numeric/perceptron_kernels.hpp"
#include "support/instruction_sets.hpp"
#include "support/scalar_perceptron.hpp"

namespace proofmass {
namespace {

using test::Real;
using test::RealVector;
using Columns = std::vector<RealVector>;

constexpr Real kTolerance = 1e-13L;

Real dot(const RealVector& a, const RealVector& b) {
  Real sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

Real length(const RealVector& a) { return std::sqrt(dot(a, a)); }

// A random network with a few fixed columns, samples, and a random well conditioned upper triangular
// transform.
struct Case {
  PerceptronShape shape;
  Samples samples;
  ColumnBlock fixed;
  std::vector<double> weights;
  Matrix transform, projection;

  Case(const PerceptronShape& network, std::size_t rows, std::size_t fixed_columns, RandomStream& random)
      : shape(network),
        samples(test::random_samples(network.inputs, rows, random)),
        fixed(fixed_columns, samples.padded_rows()),
        weights(test::random_vector(network.parameters() + fixed_columns, random)),
        transform(network.output_weights() + fixed_columns, network.output_weights() + fixed_columns),
        projection(network.output_weights() + fixed_columns, network.hidden_weights()) {
    for (std::size_t c = 0; c < fixed_columns; ++c) {
      for (std::size_t row = 0; row < rows; ++row) fixed.column(c)[row] = random.normal();
    }
    for (std::size_t c = 0; c < transform.columns(); ++c) {
      for (std::size_t r = 0; r < c; ++r) transform(r, c) = 0.3 * random.normal();
      transform(c, c) = random.uniform(0.5, 1.5);
    }
    for (std::size_t c = 0; c < projection.columns(); ++c) {
      for (double& value : projection.column(c)) value = 0.3 * random.normal();
    }
  }

  [[nodiscard]] std::span<const double> output() const {
    return std::span(weights).subspan(shape.hidden_weights());
  }

  // Activations, ones and fixed columns.
  [[nodiscard]] Columns phi() const {
    Columns columns(transform.columns(), RealVector(samples.rows(), 1.0L));
    for (std::size_t row = 0; row < samples.rows(); ++row) {
      const RealVector x = test::sample_inputs(samples, row);
      for (std::size_t j = 0; j < shape.hidden; ++j) {
        columns[j][row] = test::scalar_activation(shape, weights, j, x);
      }
      for (std::size_t c = 0; c < fixed.columns(); ++c) {
        columns[shape.output_weights() + c][row] = fixed.column(c)[row];
      }
    }
    return columns;
  }

  [[nodiscard]] RealVector error() const {
    RealVector e(samples.target().begin(), samples.target().end());
    const Columns columns = phi();
    for (std::size_t c = 0; c < columns.size(); ++c) {
      for (std::size_t row = 0; row < e.size(); ++row) e[row] -= columns[c][row] * output()[c];
    }
    return e;
  }

  // phi * transform.
  [[nodiscard]] Columns q() const {
    const Columns columns = phi();
    Columns result(columns.size(), RealVector(samples.rows()));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      for (std::size_t row = 0; row < samples.rows(); ++row) {
        for (std::size_t k = 0; k <= i; ++k) result[i][row] += columns[k][row] * transform(k, i);
      }
    }
    return result;
  }

  // The derivatives of the output by the hidden weights.
  [[nodiscard]] Columns jacobian() const {
    Columns columns(shape.hidden_weights());
    for (std::size_t row = 0; row < samples.rows(); ++row) {
      const RealVector gradient =
          test::scalar_hidden_gradient(shape, weights, output(), test::sample_inputs(samples, row));
      for (std::size_t c = 0; c < columns.size(); ++c) columns[c].push_back(gradient[c]);
    }
    return columns;
  }

  // Those less q * projection.
  [[nodiscard]] Columns projected() const {
    Columns columns = jacobian();
    const Columns basis = q();
    for (std::size_t c = 0; c < columns.size(); ++c) {
      for (std::size_t k = 0; k < basis.size(); ++k) {
        for (std::size_t row = 0; row < samples.rows(); ++row)
          columns[c][row] -= basis[k][row] * projection(k, c);
      }
    }
    return columns;
  }
};

std::vector<Case> cases(std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Case> list;
  for (const std::size_t rows : {1U, 7U, 8U, 31U, 33U, 255U, 256U, 257U, 300U}) {
    list.emplace_back(PerceptronShape{.inputs = 1 + random.index(4), .hidden = 1 + random.index(25)}, rows,
                      random.index(6), random);
    list.emplace_back(PerceptronShape{.inputs = 3, .hidden = 7}, rows, 0, random);
  }
  return list;
}

std::string describe(const Case& c) {
  return std::to_string(c.shape.inputs) + "-" + std::to_string(c.shape.hidden) + "-1, " +
         std::to_string(c.samples.rows()) + " rows";
}

class HiddenKernels : public test::OnInstructionSet {};
INSTANTIATE_TEST_SUITE_P(InstructionSets, HiddenKernels, testing::ValuesIn(test::instruction_sets()),
                         test::instruction_set_name);

TEST_P(HiddenKernels, ActivationsAreTanhAndZeroInThePadding) {
  for (const Case& c : cases(1)) {
    SCOPED_TRACE(describe(c));
    ColumnBlock activations(c.shape.hidden, c.samples.padded_rows());
    hidden_activations(c.shape, c.weights, c.samples, activations);
    const Columns phi = c.phi();
    for (std::size_t j = 0; j < c.shape.hidden; ++j) {
      for (std::size_t row = 0; row < c.samples.padded_rows(); ++row) {
        const bool real = row < c.samples.rows();
        ASSERT_LE(std::abs(activations.column(j)[row] - (real ? phi[j][row] : 0.0L)), real ? 1e-14L : 0.0L);
      }
    }
  }
}

// Sums of products of columns, with bounds for their rounding.
void expect_products(const Columns& left, const Columns& right, const Matrix& result, const char* name) {
  SCOPED_TRACE(name);
  for (std::size_t i = 0; i < left.size(); ++i) {
    for (std::size_t k = 0; k < right.size(); ++k) {
      const Real rows = static_cast<Real>(left[i].size());
      const Real size = (std::sqrt(rows) + length(left[i])) * (std::sqrt(rows) + length(right[k]));
      ASSERT_LE(std::abs(result(i, k) - dot(left[i], right[k])), kTolerance * size) << i << ", " << k;
    }
  }
}

Matrix column(const std::vector<double>& values) {
  Matrix result(values.size(), 1);
  std::copy(values.begin(), values.end(), result.column(0).begin());
  return result;
}

TEST_P(HiddenKernels, ProductsAreThoseOfTheColumns) {
  for (const Case& c : cases(2)) {
    SCOPED_TRACE(describe(c));
    PerceptronProducts products(c.shape, c.fixed.columns());
    perceptron_products(c.shape, c.weights, c.samples, c.fixed, c.transform, c.projection, products);
    const Columns q = c.q(), p = c.projected(), e{c.error()};
    expect_products(q, q, products.qq, "qq");
    expect_products(q, e, column(products.qe), "qe");
    expect_products(p, p, products.pp, "pp");
    expect_products(p, q, products.pq, "pq");
    expect_products(p, e, column(products.pe), "pe");
    Matrix dq(c.shape.hidden_weights(), q.size());
    perceptron_cross_products(c.shape, c.weights, c.samples, c.fixed, c.transform, dq);
    expect_products(c.jacobian(), q, dq, "dq");
    expect_products(e, e, column({products.ee}), "ee");
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (std::size_t k = 0; k < p.size(); ++k) ASSERT_EQ(products.pp(i, k), products.pp(k, i));
    }
  }
}

TEST_P(HiddenKernels, ProductsWithoutDerivatives) {
  for (const Case& c : cases(3)) {
    SCOPED_TRACE(describe(c));
    PerceptronProducts products(c.shape, c.fixed.columns());
    perceptron_products(c.shape, c.weights, c.samples, c.fixed, c.transform, {}, products);
    const Columns q = c.q(), e{c.error()};
    expect_products(q, q, products.qq, "qq");
    expect_products(q, e, column(products.qe), "qe");
    expect_products(e, e, column({products.ee}), "ee");
  }
}

TEST_P(HiddenKernels, CurvatureIsThatOfTheScalarNetwork) {
  RandomStream random(4);
  for (const Case& c : cases(4)) {
    SCOPED_TRACE(describe(c));
    const std::vector<double> direction = test::random_vector(c.weights.size(), random);
    const std::size_t bias = c.shape.hidden * c.shape.inputs;
    Columns second{RealVector(c.samples.rows())};
    for (std::size_t row = 0; row < c.samples.rows(); ++row) {
      const RealVector x = test::sample_inputs(c.samples, row);
      for (std::size_t j = 0; j < c.shape.hidden; ++j) {
        Real dz = direction[bias + j];
        for (std::size_t k = 0; k < c.shape.inputs; ++k) dz += direction[j * c.shape.inputs + k] * x[k];
        const Real h = test::scalar_activation(c.shape, c.weights, j, x);
        const Real dv = direction[c.shape.hidden_weights() + j];
        second[0][row] += 2 * (1 - h * h) * dz * (dv - c.output()[j] * h * dz);
      }
    }
    const std::vector<double> removed =
        random.index(2) == 0 ? std::vector<double>() : test::random_vector(c.transform.columns(), random);
    const Columns q = c.q();
    for (std::size_t k = 0; k < removed.size(); ++k) {
      for (std::size_t row = 0; row < c.samples.rows(); ++row) second[0][row] -= q[k][row] * removed[k];
    }
    std::vector<double> d_second(c.shape.hidden_weights()), q_second(c.transform.columns());
    perceptron_curvature(c.shape, c.weights, direction, c.samples, c.fixed, c.transform, removed, d_second,
                         q_second);
    expect_products(c.jacobian(), second, column(d_second), "d");
    expect_products(q, second, column(q_second), "q");
  }
}

}  // namespace
}  // namespace proofmass
