// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/assess/diagnosis/fit/residual_effect.hpp"

namespace proofmass {

// Residuals that follow an input in a way that none of the 21 terms has: a step at zero, another slope on
// either side of it, or another level in parts of its range; the most significant. Columns of the record's
// inputs count as exact.
[[nodiscard]] std::optional<ResidualEffect> find_input_structure(const FittedRows& rows);

}  // namespace proofmass
