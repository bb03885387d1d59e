// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

struct TotalLeastSquaresFit {
  std::vector<double> coefficients;  // one a column
  // (1 + |x|²) (AᵀA - s² E)⁻¹ in scaled columns, taken back to the given ones: the covariance when the
  // standard deviations given are right, to first order. Times variance_ratio it is the covariance when only
  // their ratios are.
  Matrix unscaled_covariance;
  double smallest_singular_value = 0.0;  // s: the correction's length, in standard deviations
  double gap = 0.0;  // smallest singular value of the uncertain columns alone, over s; infinite when s is 0
  std::size_t dof = 0;  // rows - columns
  // s² / dof; 0 when dof is 0.
  [[nodiscard]] double variance_ratio() const noexcept;
};

// Mixed least squares and total least squares (Van Huffel & Vandewalle, "The Total Least Squares Problem",
// SIAM 1991, section 3.6.3): columns with a standard deviation of zero are exact and stay as they are, the
// others and y are corrected by as little as makes the equations hold, each divided by its standard
// deviation. By QR of the exact columns, SVD of what is left of the others, and inverse iteration on the rows
// themselves for the last digits. The errors of the columns are taken as independent and alike in every row.
// Throws std::invalid_argument when sizes disagree, there are fewer rows than columns, a sigma is negative or
// not finite, or y_sigma or all others are zero. Where the problem has no generic solution (gap at or near 1)
// the coefficients are infinite or meaningless: look at gap.
[[nodiscard]] TotalLeastSquaresFit solve_total_least_squares(const Matrix& design, std::span<const double> y,
                                                             std::span<const double> column_sigma,
                                                             double y_sigma);

}  // namespace proofmass
