// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when rows repeat an earlier row, inputs and output, more often than rows with the same inputs have the
// same output by the rounding of the output: rows pasted twice.
[[nodiscard]] std::optional<Finding> find_duplicated_rows(const Dataset& record);

}  // namespace proofmass
