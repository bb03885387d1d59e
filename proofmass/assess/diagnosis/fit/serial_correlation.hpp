// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when the residuals of neighbouring rows are alike: slow changes that no simple trend describes. What
// the fit itself makes of white noise is allowed for (Durbin and Watson, Biometrika 37, 1950).
[[nodiscard]] std::optional<Finding> find_serial_correlation(const FittedRows& rows);

}  // namespace proofmass
