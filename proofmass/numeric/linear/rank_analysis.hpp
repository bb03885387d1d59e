// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

class GramMatrix;

// Relative to the largest, singular values below this tolerance count as zero (columns have unit length). The
// tolerance is far above the effect of rounding in the elements (a few units of 2^-52) and far below NIST
// Filip's smallest value (1e-10), so only dependence at rounding level is loss of rank. It does not grow with
// the number of rows, because writing a record twice must not change which terms it can identify.
inline constexpr double kRankTolerance = 256.0 * 0x1p-52;

// The numerical rank of a matrix, and which of its columns are dependent.
struct RankAnalysis {
  std::size_t rank = 0;
  // Columns that are not a combination of independent columns before them, ascending. Order the columns by
  // preference.
  std::vector<std::size_t> independent;
  // For each other column, in order, one vector of unit length over the unit-length columns: the combination
  // of that column and the independent ones before it that is zero. Its nonzero elements are the aliased
  // columns.
  std::vector<std::vector<double>> null_space;
  // Of the others, those whose combination is not zero but no larger than the errors of the elements explain.
  std::vector<std::size_t> hidden;
  double condition_raw = 0.0;     // 2-norm condition number of the independent columns
  double condition_scaled = 0.0;  // the same with columns scaled to unit length
};

// Decides by the singular values of the triangular factor, in one pass over the rows with memory for the
// columns only. Throws std::invalid_argument when the design is empty or has an element that is not finite.
[[nodiscard]] RankAnalysis analyse_rank(const Matrix& design, double tolerance = kRankTolerance);

// The same for the regressors of a Gram matrix, without reading the rows again. Its Cholesky factor in twice
// the working precision is as accurate as R from the rows.
[[nodiscard]] RankAnalysis analyse_rank(const GramMatrix& gram);

// A combination of columns must be this much longer than the errors of its elements make it, in squares: what
// is estimated from it is then attenuated by a ninth at most.
inline constexpr double kErrorMargin = 9.0;

// The same when the elements have errors: `errors` are the expected sums over the rows of products of the
// errors in two columns, before scaling. A column whose distance from the columns before it is no more than
// such errors make (kErrorMargin) is dependent too.
[[nodiscard]] RankAnalysis analyse_rank(const GramMatrix& gram, const Matrix& errors);

// Largest over smallest singular value with columns scaled to unit length; infinity when the smallest is
// zero.
[[nodiscard]] double scaled_condition(const Matrix& matrix);

}  // namespace proofmass
