// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

struct TotalLeastSquaresFit {
  std::vector<double> coefficients;  // one per column
  // (1 + |x|²) (AᵀA - s² E)⁻¹ in scaled columns, converted to the given columns. To first order it is the
  // covariance when the given standard deviations are correct. When only their ratios are correct, multiply
  // it by variance_ratio.
  Matrix unscaled_covariance;
  double smallest_singular_value = 0.0;  // s: length of the correction, in standard deviations
  double gap = 0.0;  // smallest singular value of the uncertain columns alone, over s; infinite when s is 0
  std::size_t dof = 0;  // rows - columns
  // s² / dof; 0 when dof is 0.
  [[nodiscard]] double variance_ratio() const noexcept;
};

// Mixed least squares and total least squares (Van Huffel & Vandewalle, "The Total Least Squares Problem",
// SIAM 1991, section 3.6.3). Columns with a standard deviation of zero are exact and stay unchanged. The
// others and y, each divided by its standard deviation, get the smallest correction that makes the equations
// hold. Method: QR of the exact columns, SVD of the remainder of the others, and inverse iteration on the
// rows for the last digits. The errors of the columns are assumed independent, with the same size in every
// row. Throws std::invalid_argument when sizes disagree, there are fewer rows than columns, a sigma is
// negative or not finite, or y_sigma or all others are zero. Where the problem has no generic solution (gap
// at or near 1) the coefficients are infinite or meaningless: check gap.
[[nodiscard]] TotalLeastSquaresFit solve_total_least_squares(const Matrix& design, std::span<const double> y,
                                                             std::span<const double> column_sigma,
                                                             double y_sigma);

}  // namespace proofmass
