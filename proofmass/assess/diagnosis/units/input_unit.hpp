// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when every |A| is what one g, as a dividing head gives it, reads as in another unit: 9.8 in g, say; or
// when |A| has a few values where one of the axes is taken to be in another unit. A record of fewer than two
// rows, or with an axis missing whose |A| varies, says nothing.
[[nodiscard]] std::optional<Finding> find_other_input_unit(const Dataset& record);

}  // namespace proofmass
