// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/linear/gram_matrix.hpp"
#include "proofmass/numeric/linear/regression_rows.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// What LeastSquaresFit tells except the figures of each row.
struct NormalSolution {
  std::vector<double> coefficients;  // one a regressor
  double rss = 0.0;                  // residual sum of squares
  std::size_t dof = 0;               // rows - regressors
  Matrix unscaled_covariance;        // (AᵀA)⁻¹; times the residual variance it is the covariance
  std::vector<double> vif;           // as LeastSquaresFit says
  // Upper triangular; the regressors as RegressionRows scales them, times this, are orthonormal columns,
  // whose rows' squared lengths are the leverages.
  Matrix orthogonaliser;
};

// Minimises |y - A c| by the normal equations AᵀA c = Aᵀy, summed and solved in twice the working precision,
// in which the squared condition number leaves more digits than Householder QR leaves in one (Golub & Van
// Loan, Matrix Computations, 5.3). `rows`, those that the sums are of, are read again only when the residuals
// are so small that the sums cannot tell their squares. Throws std::invalid_argument when there are fewer
// rows than regressors, an element is not finite, or the columns lack full rank by analyse_rank's rule.
[[nodiscard]] NormalSolution solve_normal_equations(const GramMatrix& gram, const RegressionRows& rows);

// The sum of squared residuals that any coefficients leave over the rows that the sums are of; `rows` as
// above.
[[nodiscard]] double residual_sum_of_squares(const GramMatrix& gram, const RegressionRows& rows,
                                             std::span<const double> coefficients);

// Variance inflation factors of full-rank regressors, as LeastSquaresFit says.
[[nodiscard]] std::vector<double> variance_inflation(const GramMatrix& gram);

// response - row * coefficients, one a row, in parallel.
[[nodiscard]] std::vector<double> regression_residuals(const RegressionRows& rows,
                                                       std::span<const double> coefficients);

// The diagonal of the hat matrix, one a row, in parallel, by the orthogonaliser of a solution over these
// rows.
[[nodiscard]] std::vector<double> regression_leverages(const RegressionRows& rows,
                                                       const Matrix& orthogonaliser);

}  // namespace proofmass
