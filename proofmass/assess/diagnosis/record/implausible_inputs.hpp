// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

struct UnlikeRows {
  std::vector<std::size_t> rows{};
  double others = 0.0;  // |A| of the others, in g
};

// Rows in which |A| is unlike that of nine tenths of the rows, which have one value of it (a tumble), where
// no other set-up and no output bears it out: an input is mistyped there. None where the record has no such
// value.
[[nodiscard]] UnlikeRows rows_of_unlike_magnitude(const Dataset& record);

// What is said of these rows.
[[nodiscard]] Finding unlike_magnitude(const Dataset& record, const UnlikeRows& unlike);

// Says when accelerations are larger than a test stand makes.
[[nodiscard]] std::optional<Finding> find_too_large_inputs(const Dataset& record);

// Says when an input is, in a tenth of the rows or less, many times what it is in all others: the mark of a
// missing value, or a slip. Of the first axis that has such rows.
[[nodiscard]] std::optional<Finding> find_far_input(const Dataset& record);

// Says when temperatures are below absolute zero, or few are far from all others.
[[nodiscard]] std::optional<Finding> find_implausible_temperature(const Dataset& record);

}  // namespace proofmass
