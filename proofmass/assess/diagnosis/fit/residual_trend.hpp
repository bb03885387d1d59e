// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when the residuals follow time, temperature or the order of the rows along a polynomial of degree one
// to three: the strongest of these, with its size and significance.
[[nodiscard]] std::optional<Finding> find_residual_trend(const FittedRows& rows);

}  // namespace proofmass
