// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/core/identification.hpp"

namespace proofmass {

// Says how many rows of inputs lie outside the range that the result was identified on, along some axis, and
// which is the first; nothing when none does, or when the result does not know its range.
[[nodiscard]] std::optional<Finding> find_extrapolation(const Identification& result, const Dataset& inputs);

}  // namespace proofmass
