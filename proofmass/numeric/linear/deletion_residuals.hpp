// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/linear/regression_rows.hpp"

namespace proofmass {

// What the rows of a group are left with by a fit without them.
struct DeletionResiduals {
  std::vector<double> residuals;  // one a row; NaN where the others do not determine the coefficients
  std::size_t undetermined = 0;   // groups without which the coefficients are not determined
};

// Response minus prediction of each row by the weighted least squares fit to the rows outside its group,
// without fitting again: r_g + X_g (XᵀWX - X_gᵀW X_g)⁻¹ X_gᵀW r_g (Cook and Weisberg, Residuals and Influence
// in Regression, 1982, 2.2 and 3.2). Exact when `residuals` are those of least squares with these weights;
// otherwise one step with the weights held, which is a little too small where the
// row's own weight would change. `weights`: one a row, finite and not negative, or empty
// for all alike. `group`: of each row, below `groups`; or empty: each row alone. Memory: some thousand
// times the regressors squared. Where the weighted rows lack full rank, no group is determined. Throws
// std::invalid_argument where the sizes disagree.
[[nodiscard]] DeletionResiduals deletion_residuals(const RegressionRows& rows,
                                                   std::span<const double> residuals,
                                                   std::span<const double> weights,
                                                   std::span<const std::size_t> group = {},
                                                   std::size_t groups = 0);

}  // namespace proofmass
