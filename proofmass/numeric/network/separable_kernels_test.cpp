// SPDX-License-Identifier: Apache-2.0
// Compares the kernels of variable projection with plain dense algebra in extended precision.
#include "proofmass/numeric/network/separable_kernels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

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

  [[nodiscard]] SeparableNetwork network() const { return {shape, weights, samples, fixed, transform}; }
  [[nodiscard]] SeparableState state() const { return {shape, fixed.columns(), samples}; }

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

  // D - q * projection.
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

void expect_basis_products(const Case& c, const BasisProducts& products) {
  const Columns q = c.q(), e{c.error()};
  expect_products(q, q, products.qq, "qq");
  expect_products(q, e, column(products.qe), "qe");
  expect_products(e, e, column({products.ee}), "ee");
}

void expect_projected_products(const Case& c, const Matrix& dq, const Matrix& pp,
                               const std::vector<double>& pe) {
  const Columns p = c.projected();
  Matrix whole = pp;  // only the lower triangle is summed
  for (std::size_t k = 0; k < p.size(); ++k) {
    for (std::size_t i = 0; i < k; ++i) whole(i, k) = pp(k, i);
  }
  expect_products(c.jacobian(), c.q(), dq, "dq");
  expect_products(p, p, whole, "pp");
  expect_products(p, {c.error()}, column(pe), "pe");
}

// The sums of a case.
struct Sums {
  explicit Sums(const Case& c)
      : basis(c.transform.columns()),
        dq(c.shape.hidden_weights(), c.transform.columns()),
        pp(c.shape.hidden_weights(), c.shape.hidden_weights()),
        pe(c.shape.hidden_weights()) {}

  BasisProducts basis;
  Matrix dq, pp;
  std::vector<double> pe;
};

TEST_P(HiddenKernels, ProductsAreThoseOfTheColumns) {
  for (const Case& c : cases(2)) {
    SCOPED_TRACE(describe(c));
    SeparableState state = c.state();
    Sums sums(c);
    sum_projected_products(c.network(), state, c.projection, sums.pp, sums.pe, nullptr);
    state.kept = Kept::nothing;
    sum_cross_products(c.network(), state, sums.dq);
    state.kept = Kept::nothing;
    sum_basis_products(c.network(), state, sums.basis);
    expect_basis_products(c, sums.basis);
    expect_projected_products(c, sums.dq, sums.pp, sums.pe);
  }
}

// The columns kept stand for the hidden weights, the transform and the output weights in turn. A pass that is
// told which of them are unchanged must use the right columns, kept or not.
TEST_P(HiddenKernels, ProductsAreTheSameOfColumnsKept) {
  for (Case& c : cases(3)) {
    SCOPED_TRACE(describe(c));
    SeparableState state = c.state();
    ASSERT_TRUE(state.columns.keeps());
    Sums sums(c);
    sum_basis_products(c.network(), state, sums.basis);
    EXPECT_EQ(state.kept, Kept::basis);
    for (std::size_t k = 0; k < c.transform.columns(); ++k) c.transform(0, k) += 0.25;
    state.kept = Kept::activations;
    sum_basis_products(c.network(), state, sums.basis);
    expect_basis_products(c, sums.basis);
    for (std::size_t k = c.shape.hidden_weights(); k < c.weights.size(); ++k) c.weights[k] *= -1.5;
    sum_basis_products(c.network(), state, sums.basis);
    expect_basis_products(c, sums.basis);
    c.weights.back() += 1.0;
    sum_cross_products(c.network(), state, sums.dq);
    EXPECT_EQ(state.kept, Kept::derivatives);
    sum_projected_products(c.network(), state, c.projection, sums.pp, sums.pe, nullptr);
    expect_projected_products(c, sums.dq, sums.pp, sums.pe);
  }
}

TEST_P(HiddenKernels, ProductsOfMoreSamplesThanAreKept) {
  RandomStream random(5);
  const Case c({.inputs = 3, .hidden = 7}, 30000, 0, random);
  SeparableState state = c.state();
  ASSERT_FALSE(state.columns.keeps());
  Sums sums(c);
  sum_basis_products(c.network(), state, sums.basis);
  sum_cross_products(c.network(), state, sums.dq);
  sum_projected_products(c.network(), state, c.projection, sums.pp, sums.pe, nullptr);
  expect_basis_products(c, sums.basis);
  expect_projected_products(c, sums.dq, sums.pp, sums.pe);
}

TEST_P(HiddenKernels, SecondDerivativeIsThatOfTheScalarNetwork) {
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
    const Columns q = c.q();
    SeparableState state = c.state();
    std::vector<double> products(q.size());
    sum_second_basis(c.network(), state, direction, products);
    EXPECT_EQ(state.kept, Kept::second);
    expect_products(q, second, column(products), "q");
    // The second derivative minus a part in q, which need not be its projection.
    std::vector<double> removed(q.size());
    for (double& coefficient : removed) coefficient = random.normal();
    for (std::size_t k = 0; k < q.size(); ++k) {
      for (std::size_t row = 0; row < c.samples.rows(); ++row) second[0][row] -= removed[k] * q[k][row];
    }
    std::vector<double> d_second(c.shape.hidden_weights());
    for (const Kept kept : {Kept::second, Kept::derivatives, Kept::nothing}) {
      state.kept = kept;
      sum_second_derivative(c.network(), state, direction, removed, d_second, products);
      EXPECT_EQ(state.kept, Kept::derivatives);
      expect_products(c.jacobian(), second, column(d_second), "d");
      expect_products(q, second, column(products), "q");
    }
  }
}

TEST_P(HiddenKernels, ProjectedColumnsTimesBasis) {
  for (const Case& c : cases(5)) {
    SCOPED_TRACE(describe(c));
    SeparableState state = c.state();
    Sums sums(c);
    Matrix pq(c.shape.hidden_weights(), c.transform.columns());
    sum_projected_products(c.network(), state, c.projection, sums.pp, sums.pe, &pq);
    expect_products(c.projected(), c.q(), pq, "pq");
  }
}

}  // namespace
}  // namespace proofmass
