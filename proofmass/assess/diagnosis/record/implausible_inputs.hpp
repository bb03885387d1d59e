// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Rows in which |A| is unlike that of nine tenths of the rows, which have one value of it (a tumble), where
// no other row and no output bears it out: an input is mistyped there. Empty where there are none, and where
// the record has no such value.
[[nodiscard]] std::vector<std::size_t> rows_of_unlike_magnitude(const Dataset& record);

// What is said of these rows.
[[nodiscard]] Finding unlike_magnitude(const Dataset& record, const std::vector<std::size_t>& rows);

// Says when accelerations are larger than a test stand makes, or temperatures are none of a laboratory.
[[nodiscard]] std::vector<Finding> find_implausible_inputs(const Dataset& record);

}  // namespace proofmass
