// SPDX-License-Identifier: Apache-2.0
// The kernels of variable projection against plain dense algebra in extended precision.
#include <gtest/gtest.h>

#include <cmath>
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

Columns columns_of(const ColumnBlock& block, std::size_t rows) {
  Columns columns;
  for (std::size_t c = 0; c < block.columns(); ++c) {
    columns.emplace_back(block.column(c), block.column(c) + rows);
  }
  return columns;
}

// A random network, samples, and a random well conditioned upper triangular transform of its activations.
struct Case {
  PerceptronShape shape;
  Samples samples;
  std::vector<double> hidden_weights, v;
  Matrix transform;
  ColumnBlock phi, q, residual;

  Case(const PerceptronShape& network, std::size_t rows, RandomStream& random)
      : shape(network),
        samples(test::random_samples(network.inputs, rows, random)),
        hidden_weights(test::random_vector(network.hidden_weights(), random)),
        v(test::random_vector(network.output_weights(), random)),
        transform(network.output_weights(), network.output_weights()),
        phi(network.output_weights(), samples.padded_rows()),
        q(network.output_weights(), samples.padded_rows()),
        residual(1, samples.padded_rows()) {
    for (std::size_t c = 0; c < transform.columns(); ++c) {
      for (std::size_t r = 0; r < c; ++r) transform(r, c) = 0.3 * random.normal();
      transform(c, c) = random.uniform(0.5, 1.5);
    }
    hidden_activations(shape, hidden_weights, samples, phi);
  }

  [[nodiscard]] RealVector target() const { return {samples.target().begin(), samples.target().end()}; }

  // The derivatives of phi * v by the hidden weights.
  [[nodiscard]] Columns jacobian() const {
    Columns columns(shape.hidden_weights());
    for (std::size_t row = 0; row < samples.rows(); ++row) {
      const RealVector gradient =
          test::scalar_hidden_gradient(shape, hidden_weights, v, test::sample_inputs(samples, row));
      for (std::size_t c = 0; c < columns.size(); ++c) columns[c].push_back(gradient[c]);
    }
    return columns;
  }
};

std::vector<Case> cases(std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Case> list;
  for (const std::size_t rows : {1U, 7U, 8U, 127U, 128U, 129U, 300U}) {
    list.emplace_back(PerceptronShape{.inputs = 1 + random.index(3), .hidden = 1 + random.index(25)}, rows,
                      random);
    list.emplace_back(PerceptronShape{.inputs = 3, .hidden = 7}, rows, random);
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

TEST_P(HiddenKernels, ActivationsAreTanhAndOnesAndZeroInThePadding) {
  for (const Case& c : cases(1)) {
    SCOPED_TRACE(describe(c));
    for (std::size_t row = 0; row < c.samples.padded_rows(); ++row) {
      const bool real = row < c.samples.rows();
      ASSERT_EQ(c.phi.column(c.shape.hidden)[row], real ? 1.0 : 0.0);
      for (std::size_t j = 0; j < c.shape.hidden; ++j) {
        const Real expected =
            real ? test::scalar_activation(c.shape, c.hidden_weights, j, test::sample_inputs(c.samples, row))
                 : 0.0L;
        ASSERT_LE(std::abs(c.phi.column(j)[row] - expected), real ? 1e-14L : 0.0L);
      }
    }
  }
}

TEST_P(HiddenKernels, TransformedColumnsAndTheirGramMatrix) {
  for (Case& c : cases(2)) {
    SCOPED_TRACE(describe(c));
    const std::size_t n = c.phi.columns();
    Matrix gram(n, n);
    std::vector<double> qty(n);
    transform_columns(c.phi, c.transform, c.samples, c.q, gram, qty);
    const Columns phi = columns_of(c.phi, c.samples.rows());
    Columns q(n, RealVector(c.samples.rows()));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t row = 0; row < c.samples.rows(); ++row) {
        for (std::size_t k = 0; k <= i; ++k) q[i][row] += phi[k][row] * c.transform(k, i);
        ASSERT_LE(std::abs(c.q.column(i)[row] - q[i][row]), kTolerance);
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_LE(std::abs(qty[i] - dot(q[i], c.target())),
                kTolerance * (1 + length(q[i])) * length(c.target()));
      for (std::size_t k = 0; k < n; ++k) {
        ASSERT_LE(std::abs(gram(k, i) - dot(q[k], q[i])),
                  kTolerance * (1 + length(q[k])) * (1 + length(q[i])));
        ASSERT_EQ(gram(k, i), gram(i, k));
      }
    }
  }
}

TEST_P(HiddenKernels, ResidualAndItsProducts) {
  for (Case& c : cases(3)) {
    SCOPED_TRACE(describe(c));
    const std::size_t n = c.phi.columns();
    Matrix gram(n, n);
    std::vector<double> products(n);
    transform_columns(c.phi, c.transform, c.samples, c.q, gram, products);
    const double sum = column_residual(c.phi, c.v, c.samples, c.q, c.residual, products);
    const Columns phi = columns_of(c.phi, c.samples.rows());
    RealVector e = c.target();
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t row = 0; row < e.size(); ++row) e[row] -= phi[k][row] * c.v[k];
    }
    const Real size = length(e) + length(c.target()) + static_cast<Real>(n * e.size());
    ASSERT_LE(std::abs(sum - dot(e, e)), kTolerance * size * (1 + length(e)));
    for (std::size_t row = 0; row < e.size(); ++row) {
      ASSERT_LE(std::abs(c.residual.column(0)[row] - e[row]), kTolerance * static_cast<Real>(n));
    }
    for (std::size_t row = e.size(); row < c.samples.padded_rows(); ++row) {
      ASSERT_EQ(c.residual.column(0)[row], 0.0);
    }
    const Columns q = columns_of(c.q, c.samples.rows());
    for (std::size_t k = 0; k < n; ++k) {
      ASSERT_LE(std::abs(products[k] - dot(q[k], e)), kTolerance * (1 + length(q[k])) * size);
    }
  }
}

TEST_P(HiddenKernels, ProductsAndNormalEquationsOfTheProjectedJacobian) {
  for (Case& c : cases(4)) {
    SCOPED_TRACE(describe(c));
    const std::size_t n = c.phi.columns();
    const std::size_t p = c.shape.hidden_weights();
    Matrix gram(n, n), cross(n, p), normal(p, p);
    std::vector<double> scratch(n), gradient(p), dt_residual(p), qt_residual(n);
    transform_columns(c.phi, c.transform, c.samples, c.q, gram, scratch);
    column_residual(c.phi, c.v, c.samples, c.q, c.residual, scratch);
    hidden_jacobian_cross(c.shape, c.v, c.phi, c.q, c.samples, cross);
    hidden_jacobian_transposed(c.shape, c.v, c.phi, c.q, c.residual, c.samples, dt_residual, qt_residual);

    const Columns q = columns_of(c.q, c.samples.rows());
    const RealVector e = columns_of(c.residual, c.samples.rows())[0];
    Columns d = c.jacobian();
    const Real rows = static_cast<Real>(c.samples.rows());
    for (std::size_t k = 0; k < n; ++k) ASSERT_EQ(qt_residual[k], scratch[k]);
    for (std::size_t i = 0; i < p; ++i) {
      ASSERT_LE(std::abs(dt_residual[i] - dot(d[i], e)), kTolerance * (rows + length(d[i]) * length(e)));
      for (std::size_t k = 0; k < n; ++k) {
        ASSERT_LE(std::abs(cross(k, i) - dot(q[k], d[i])), kTolerance * (rows + length(q[k]) * length(d[i])));
        cross(k, i) /= static_cast<double>(c.samples.rows());  // any matrix will do for the projection
      }
    }
    projected_normal_equations(c.shape, c.v, c.phi, c.q, cross, c.residual, c.samples, normal, gradient);
    for (std::size_t i = 0; i < p; ++i) {
      for (std::size_t k = 0; k < n; ++k) {
        for (std::size_t row = 0; row < e.size(); ++row) d[i][row] -= q[k][row] * cross(k, i);
      }
    }
    for (std::size_t i = 0; i < p; ++i) {
      const Real size = 10 * std::sqrt(rows) + length(d[i]);
      ASSERT_LE(std::abs(gradient[i] - dot(d[i], e)), kTolerance * size * (1 + length(e)));
      for (std::size_t k = 0; k < p; ++k) {
        ASSERT_LE(std::abs(normal(k, i) - dot(d[k], d[i])),
                  kTolerance * size * (10 * std::sqrt(rows) + length(d[k])));
        ASSERT_EQ(normal(k, i), normal(i, k));
      }
    }
  }
}

}  // namespace
}  // namespace proofmass
