// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

class GramMatrix;

// Singular values of a matrix with unit-length columns below this share of the largest count as zero. It is
// far above what rounding in the elements can cause (a few units of 2^-52) and far below NIST Filip's
// smallest (1e-10), so only dependence at rounding level is rank loss. It does not grow with the number of
// rows: writing a record twice must not change what it can identify.
inline constexpr double kRankTolerance = 256.0 * 0x1p-52;

// How much of its column space a matrix really has.
struct RankAnalysis {
  std::size_t rank = 0;
  // Columns that are no combination of independent columns before them, ascending: order columns by
  // preference.
  std::vector<std::size_t> independent;
  // One vector of unit length for each other column, in order, over the unit-length columns: the combination
  // of that column and of the independent ones before it that vanishes. Its support names what cannot be told
  // apart.
  std::vector<std::vector<double>> null_space;
  double condition_raw = 0.0;     // 2-norm condition number of the independent columns
  double condition_scaled = 0.0;  // the same with columns scaled to unit length
};

// Decides by the singular values of the triangular factor, which takes one pass over the rows and memory for
// the columns alone. Throws std::invalid_argument when the design is empty or has an element that is not
// finite.
[[nodiscard]] RankAnalysis analyse_rank(const Matrix& design, double tolerance = kRankTolerance);

// The same of the regressors that a Gram matrix is of, without another look at the rows: by R from its
// Cholesky factor in twice the working precision, which is as good as the one from the rows.
[[nodiscard]] RankAnalysis analyse_rank(const GramMatrix& gram);

// Largest over smallest singular value with columns scaled to unit length; infinity when the smallest is
// zero.
[[nodiscard]] double scaled_condition(const Matrix& matrix);

}  // namespace proofmass
