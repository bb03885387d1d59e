// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/core/identification.hpp"

namespace proofmass {

// Says when Ki is negative, when a cross axis is larger than it, and when it is far from one although the
// output is an acceleration, or has no declared unit and counts as one, with what Ki then looks like.
[[nodiscard]] std::vector<Finding> find_implausible_scale_factor(const FittedRows& rows,
                                                                 const Identification& result);

}  // namespace proofmass
