// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when a fit explains less than nine tenths of its outputs' variance (R² below 0.9), with the likeliest
// reason: terms left out, a few rows far off, outputs a few rows beside their inputs, angles for inputs, or
// an output that does not depend on the inputs.
[[nodiscard]] std::optional<Finding> find_misfit(const FittedRows& rows, const Identification& result);

}  // namespace proofmass
