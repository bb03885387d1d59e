// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/linear/regression_rows.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

struct WeightedFit {
  std::vector<double> coefficients;  // one a column
  std::vector<double> residuals;     // y - design * coefficients, one a row, as they are (not weighted)
  double rss = 0.0;                  // sum of squared residuals
  double weighted_rss = 0.0;         // sum of weight * residual²
  Matrix unscaled_covariance;        // (designᵀ W design)⁻¹
  std::vector<double> leverage;      // diagonal of the hat matrix of the row-scaled problem, one a row
};

// Minimises the sum of weight * residual² by solve_least_squares on rows scaled by the weights' square roots
// (Golub & Van Loan, Matrix Computations, 6.1). Weights of zero take rows out. Throws std::invalid_argument
// when a weight is negative or not finite, the sizes disagree, or the row-scaled design lacks full column
// rank.
[[nodiscard]] WeightedFit solve_weighted_least_squares(const Matrix& design, std::span<const double> y,
                                                       std::span<const double> weights);

// The same from the normal equations in twice the working precision (normal_solution.hpp), in passes over the
// rows that hold nothing but the figures of each row.
[[nodiscard]] WeightedFit solve_weighted_least_squares(const RegressionRows& rows,
                                                       std::vector<double> weights);

}  // namespace proofmass
