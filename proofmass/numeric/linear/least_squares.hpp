// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/linear/rank_analysis.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

struct LeastSquaresFit {
  std::vector<double> coefficients;  // one per column
  std::vector<double> residuals;     // y - design * coefficients, one per row
  double rss = 0.0;                  // residual sum of squares
  std::size_t dof = 0;               // rows - columns
  Matrix unscaled_covariance;  // (designᵀ design)⁻¹; times the residual variance it is the covariance
  // Variance inflation factor of each column: 1 / (1 - R²) of its regression on the others, about the mean
  // when the design has a constant column; NaN for a constant column.
  std::vector<double> vif;
  std::vector<double> leverage;  // diagonal of the hat matrix, one per row
  // sqrt(rss / dof); 0 when dof is 0.
  [[nodiscard]] double residual_sd() const noexcept;
};

// Minimises |y - design * c| by Householder QR with column pivoting (Golub & Van Loan, Matrix Computations,
// 5.4); the columns are scaled to length one within a factor of two. Then refines coefficients and residuals
// together on the augmented system, with residuals in twice the working precision (Björck, BIT 7, 1967).
// Throws std::invalid_argument unless the design has full column rank by analyse_rank's rule and at least as
// many rows as columns.
[[nodiscard]] LeastSquaresFit solve_least_squares(const Matrix& design, std::span<const double> y);

}  // namespace proofmass
