// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"

namespace proofmass {

// What a robust fit (bisquare) of the terms leaves of all rows, by the method's weights; made from a sample
// of the rows. Nothing where these are few beside the terms, or the robust scale cannot be trusted.
[[nodiscard]] std::optional<std::vector<double>> robust_residuals(const FittedRows& rows);

}  // namespace proofmass
