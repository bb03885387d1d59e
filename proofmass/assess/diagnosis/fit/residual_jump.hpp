// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/residual_effect.hpp"

namespace proofmass {

// A change of the output, or of the scale factor, from one row on, or from one row to another.
[[nodiscard]] std::optional<ResidualEffect> find_residual_jump(const FittedRows& rows);

// Residuals that differ between rows where Ai has risen and rows where it has fallen since the row before.
[[nodiscard]] std::optional<ResidualEffect> find_hysteresis(const FittedRows& rows);

}  // namespace proofmass
