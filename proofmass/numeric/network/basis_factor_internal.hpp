// SPDX-License-Identifier: Apache-2.0
// Factors of the columns phi that a network's output is linear in. The columns may be nearly dependent. q =
// phi * transform, with an upper triangular transform, spans the same space and is well conditioned.
#pragma once

#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// With a condition number up to this, the normal equations of the columns lose no important digit.
inline constexpr double kWellConditioned = 30.0;

// Inverse of the Gram matrix of q, restricted to the span of its columns when they are dependent. Returns a
// bound of their condition number, which is infinite in that case.
double invert_gram(const Matrix& gram, Matrix& inverse);

// Makes q orthonormal to rounding by its Gram matrix (Cholesky QR: Yamamoto et al. 2015). No column of phi is
// longer than `largest_norm`. A column in the span of those before it is left out: its column of the
// transform becomes zero.
void orthonormalise(Matrix& transform, Matrix& gram, double largest_norm);

// Includes columns that were left out before.
void restore_dropped(Matrix& transform);

}  // namespace proofmass
