// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace proofmass {

// Of each row, the last earlier row that equals it in every one of the columns, which have `rows` finite
// numbers each; the row itself where none does. Zero equals minus zero.
[[nodiscard]] std::vector<std::size_t> earlier_equals(std::size_t rows,
                                                      std::span<const std::vector<double>* const> columns);

// How many rows equal an earlier one.
[[nodiscard]] std::size_t count_repeats(std::size_t rows,
                                        std::span<const std::vector<double>* const> columns);

}  // namespace proofmass
