// SPDX-License-Identifier: Apache-2.0
// Batch kernels of variable projection, vectorised; the instruction set is chosen at run time. Each call uses
// one thread and needs at least one sample.
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

// A network over its samples. phi are the columns that its output is linear in (hidden activations, ones,
// fixed columns); q = phi * transform, e = target - output, D the derivatives of the output by the hidden
// weights.
struct SeparableNetwork {
  const PerceptronShape& shape;
  std::span<const double> weights;  // those of the network, then one for each fixed column
  const Samples& samples;
  const ColumnBlock& fixed;  // columns of padded_rows() values, zero in the padding; there may be none
  const Matrix& transform;   // upper triangular, as many columns as phi
};

// What a pass can reuse from an earlier one, if columns are kept. Each value includes those before it.
enum class Kept {
  nothing,
  activations,  // of the same hidden weights
  basis,        // also q, with the same transform
  derivatives,  // also the error and the units' slopes, with the same output weights
  second        // also the second derivative along the last direction
};

// Columns that the kernels work with (q, error, second derivative, activations, slopes), and which of them
// are valid. Kernels add to the valid ones; whoever changes the network must reset this.
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

// Keeps the basis.
void sum_basis_products(const SeparableNetwork& network, SeparableState& state, BasisProducts& products);

// dq = Dᵀq, hidden weights by columns of q. Keeps the derivatives.
void sum_cross_products(const SeparableNetwork& network, SeparableState& state, Matrix& dq);

// With P = D - q * projection: pp = PᵀP (its lower triangle), pe = Pᵀe and, unless null, pq = Pᵀq. Keeps the
// derivatives.
void sum_projected_products(const SeparableNetwork& network, SeparableState& state, const Matrix& projection,
                            Matrix& pp, std::span<double> pe, Matrix* pq);

// q_second = qᵀs, with s the second derivative of the output along `direction` (of all weights). Keeps s.
void sum_second_basis(const SeparableNetwork& network, SeparableState& state,
                      std::span<const double> direction, std::span<double> q_second);

// With q * removed subtracted from s: d_second = Dᵀs, q_second = qᵀs. An s kept from an earlier pass is used
// as it is. Keeps the derivatives.
void sum_second_derivative(const SeparableNetwork& network, SeparableState& state,
                           std::span<const double> direction, std::span<const double> removed,
                           std::span<double> d_second, std::span<double> q_second);

}  // namespace proofmass
