// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when outputs that are counts, or whole numbers, fall into groups 2^n apart, n from 8 to 24, and moving
// the upper group down by 2^n makes them follow the inputs at least three times as closely: signed counts
// read as unsigned, or a counter that ran over.
[[nodiscard]] std::optional<Finding> find_wrapped_counts(const Dataset& record);

}  // namespace proofmass
