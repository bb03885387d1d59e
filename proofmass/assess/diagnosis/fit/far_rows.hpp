// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when rows lie so far from the fit that they are no noise: by the scale of the residuals' median, or,
// one row alone, by what a fit without it leaves of the others. With `masked_too`, where there are none, by a
// robust fit too: so many that they hide each other in the residuals of any other. Not of robust fits, which
// say what they suspect.
[[nodiscard]] std::optional<Finding> find_far_rows(const FittedRows& rows, const Identification& result,
                                                   bool masked_too);

}  // namespace proofmass
