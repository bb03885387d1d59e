// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// Residuals that follow time, temperature or the order of the rows.
struct ResidualTrend {
  Finding finding;
  double errors = 0.0;  // standard errors from zero
  Matrix columns;       // orthonormal, beyond the terms: polynomials of the quantity, up to degree three
};

// The strongest trend of the residuals, or of the residuals in proportion to Ai (a scale factor that drifts),
// along a polynomial of degree one to three, with its size and significance.
[[nodiscard]] std::optional<ResidualTrend> find_residual_trend(const FittedRows& rows);

}  // namespace proofmass
