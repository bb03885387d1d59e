// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "proofmass/numeric/linear/regression_rows.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// A fit whose coefficients solve sum w r x = 0 over its rows.
struct EstimatingRows {
  const RegressionRows& rows;
  std::span<const double> residuals;
  std::span<const double> weights;  // finite and not negative; empty: all alike
  // d(w r)/dr of each row, which may be negative where a loss is bounded; empty: the weights.
  std::span<const double> slopes{};
};

struct DeletionCovariance {
  Matrix covariance;  // of the coefficients; empty where some group is undetermined, or `flat`
  // The sum of a x xᵀ over all rows is not positive definite: the slopes say nothing of some direction.
  bool flat = false;
  // The first group without which the coefficients are not determined.
  std::optional<std::size_t> undetermined{};
};

// Covariance of the coefficients from how they change when each group of rows is left out, without a model of
// the noise: the sum over groups of d dᵀ, d = (sum a x xᵀ of the others)⁻¹ sum w r x of the group, with
// slopes a. Each row alone: HC3 (MacKinnon & White, J. Econometrics 29, 1985). Groups: the sum times (G - 1)
// / G, CR3, the jackknife over clusters (Bell & McCaffrey, Survey Methodology 28, 2002). `group`: of each
// row, below `groups`; or empty: each row alone. Exact for least squares with these weights; otherwise one
// step. Throws std::invalid_argument where the sizes disagree.
[[nodiscard]] DeletionCovariance deletion_covariance(const EstimatingRows& fit,
                                                     std::span<const std::size_t> group = {},
                                                     std::size_t groups = 0);

}  // namespace proofmass
