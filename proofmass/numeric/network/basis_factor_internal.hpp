// SPDX-License-Identifier: Apache-2.0
// Factors of what a network's output is linear in: columns phi that may be close to dependent, and q = phi *
// transform, upper triangular, which spans the same and is well conditioned.
#pragma once

#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// Columns this well conditioned lose no digit that matters to their own normal equations.
inline constexpr double kWellConditioned = 30.0;

// Inverse of the Gram matrix of q, on the span of its columns alone where they are dependent. Returns a bound
// of their condition number, infinite in that case.
double invert_gram(const Matrix& gram, Matrix& inverse);

// Makes q orthonormal to rounding by its Gram matrix (Cholesky QR: Yamamoto et al. 2015). A column of phi,
// none of them longer than `largest_norm`, that lies in the span of those before it is left out: its column
// of the transform becomes zero.
void orthonormalise(Matrix& transform, Matrix& gram, double largest_norm);

// Gives columns left out another chance.
void restore_dropped(Matrix& transform);

}  // namespace proofmass
