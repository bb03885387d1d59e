// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/assess/diagnosis/fit/residual_effect.hpp"

namespace proofmass {

// Residuals that follow time, temperature or the order of the rows: the strongest trend of the residuals, or
// of the residuals in proportion to Ai (a scale factor that drifts), along a polynomial of degree one to
// three, with its size and significance. Where the rows are in the order of an input, that order is no trend,
// nor is any quantity in step with it where the inputs are uncertain.
[[nodiscard]] std::optional<ResidualEffect> find_residual_trend(const FittedRows& rows);

}  // namespace proofmass
