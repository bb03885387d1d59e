// SPDX-License-Identifier: Apache-2.0
// Batch kernels of variable projection, vectorised, chosen at run time for the processor. One thread each,
// of one sample at least.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/network/perceptron.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"
#include "proofmass/numeric/samples.hpp"
#include "proofmass/numeric/simd/block_columns.hpp"

namespace proofmass {

// A network over its samples, with phi the columns that its output is linear in (hidden activations, ones,
// fixed columns), q = phi * transform, e = target - output, D the derivatives of the output by the hidden
// weights.
struct SeparableNetwork {
  const PerceptronShape& shape;
  std::span<const double> weights;  // those of the shape, then one for each fixed column
  const Samples& samples;
  const ColumnBlock& fixed;  // columns of padded_rows() values, zero in the padding; may have none
  const Matrix& transform;   // upper triangular, as many columns as phi
};

// What a pass finds of an earlier one, if columns are kept at all.
enum class Kept {
  nothing,
  activations,  // of the same hidden weights
  basis,        // and q, of the same transform
  derivatives,  // and the error and the units' slopes, of the same output weights
  second        // and the second derivative along the last direction
};

// Columns that the kernels work with: q, error, second derivative, activations, slopes; and what they hold,
// which kernels add to. Who changes the network says what still holds.
struct SeparableState {
  SeparableState() = default;
  SeparableState(const PerceptronShape& shape, std::size_t fixed, const Samples& samples)
      : columns(shape.output_weights() + fixed + 2 + 2 * shape.hidden, samples.padded_rows()) {}

  BlockColumns columns;
  Kept kept = Kept::nothing;
};

// Sums over the samples.
struct BasisProducts {
  explicit BasisProducts(std::size_t columns) : qq(columns, columns), qe(columns) {}

  Matrix qq;               // qᵀq
  std::vector<double> qe;  // qᵀe
  double ee = 0.0;         // eᵀe
};

// Leaves the basis.
void sum_basis_products(const SeparableNetwork& network, SeparableState& state, BasisProducts& products);

// dq = Dᵀq, hidden weights by columns of q. Leaves the derivatives.
void sum_cross_products(const SeparableNetwork& network, SeparableState& state, Matrix& dq);

// With P = D - q * projection: pp = PᵀP, its lower triangle, pe = Pᵀe and, unless null, pq = Pᵀq. Leaves the
// derivatives.
void sum_projected_products(const SeparableNetwork& network, SeparableState& state, const Matrix& projection,
                            Matrix& pp, std::span<double> pe, Matrix* pq);

// q_second = qᵀs, s the second derivative of the output along `direction` (of all weights). Leaves s.
void sum_second_basis(const SeparableNetwork& network, SeparableState& state,
                      std::span<const double> direction, std::span<double> q_second);

// With s less q * removed: d_second = Dᵀs, q_second = qᵀs. Where s is left of an earlier pass, it is that
// pass's. Leaves the derivatives.
void sum_second_derivative(const SeparableNetwork& network, SeparableState& state,
                           std::span<const double> direction, std::span<const double> removed,
                           std::span<double> d_second, std::span<double> q_second);

}  // namespace proofmass
