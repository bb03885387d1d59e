// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/linear/gram_matrix.hpp"
#include "proofmass/numeric/linear/regression_rows.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// The contents of LeastSquaresFit without its figures for each row.
struct NormalSolution {
  std::vector<double> coefficients;  // one per regressor
  double rss = 0.0;                  // residual sum of squares
  std::size_t dof = 0;               // rows - regressors
  Matrix unscaled_covariance;        // (AᵀA)⁻¹; times the residual variance it is the covariance
  std::vector<double> vif;           // as in LeastSquaresFit
  // Upper triangular. The scaled regressors of RegressionRows times this matrix are orthonormal columns; the
  // squared lengths of their rows are the leverages.
  Matrix orthogonaliser;
};

// Minimises |y - A c| by the normal equations AᵀA c = Aᵀy, summed and solved in twice the working precision.
// Despite the squared condition number this leaves more digits than Householder QR in working precision
// (Golub & Van Loan, Matrix Computations, 5.3). `rows` are the rows of the sums; they are read again only
// when the residuals are too small for the sums to give their squares. Throws std::invalid_argument when
// there are fewer rows than regressors, an element is not finite, or the columns lack full rank by
// analyse_rank's rule.
[[nodiscard]] NormalSolution solve_normal_equations(const GramMatrix& gram, const RegressionRows& rows);

// The sum of squared residuals for any coefficients, over the rows of the sums; `rows` as above.
[[nodiscard]] double residual_sum_of_squares(const GramMatrix& gram, const RegressionRows& rows,
                                             std::span<const double> coefficients);

// Variance inflation factors of full-rank regressors, as in LeastSquaresFit.
[[nodiscard]] std::vector<double> variance_inflation(const GramMatrix& gram);

// response - row * coefficients for each row, in parallel.
[[nodiscard]] std::vector<double> regression_residuals(const RegressionRows& rows,
                                                       std::span<const double> coefficients);

// The diagonal of the hat matrix for each row, in parallel, from the orthogonaliser of a solution over these
// rows.
[[nodiscard]] std::vector<double> regression_leverages(const RegressionRows& rows,
                                                       const Matrix& orthogonaliser);

}  // namespace proofmass
