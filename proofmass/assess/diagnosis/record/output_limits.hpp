// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when rows with different inputs have exactly the largest, or the smallest, output (clipping), and when
// an output repeats from row to row while the inputs change (stuck, held), more than the rounding of the
// output explains.
[[nodiscard]] std::vector<Finding> find_output_limits(const Dataset& record);

}  // namespace proofmass
