// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/linear/regression_rows.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

struct WeightedFit {
  std::vector<double> coefficients;  // one per column
  std::vector<double> residuals;     // y - design * coefficients, one per row, without weights
  double rss = 0.0;                  // sum of squared residuals
  double weighted_rss = 0.0;         // sum of weight * residual²
  Matrix unscaled_covariance;        // (designᵀ W design)⁻¹
  std::vector<double> leverage;      // diagonal of the hat matrix of the row-scaled problem, one per row
};

// Minimises the sum of weight * residual² by solve_least_squares on rows scaled by the square roots of the
// weights (Golub & Van Loan, Matrix Computations, 6.1). Rows of weight zero have no effect. Throws
// std::invalid_argument when a weight is negative or not finite, the sizes disagree, or the row-scaled design
// lacks full column rank.
[[nodiscard]] WeightedFit solve_weighted_least_squares(const Matrix& design, std::span<const double> y,
                                                       std::span<const double> weights);

// The same by the normal equations in twice the working precision (normal_solution.hpp). The passes over the
// rows store only the figures of each row.
[[nodiscard]] WeightedFit solve_weighted_least_squares(const RegressionRows& rows,
                                                       std::vector<double> weights);

}  // namespace proofmass
