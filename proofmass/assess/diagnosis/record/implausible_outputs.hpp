// SPDX-License-Identifier: Apache-2.0
// Outputs, and their uncertainties, in a few rows far from those of nearly all others.
#pragma once

#include <optional>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// An output many times as large as in nearly all rows, which the input of its row does not ask for.
[[nodiscard]] std::optional<Finding> find_far_output(const Dataset& record);

// An uncertainty of the output that is thousands of times as large, or as small, as in nearly all rows.
[[nodiscard]] std::optional<Finding> find_far_sigma(const Dataset& record);

}  // namespace proofmass
