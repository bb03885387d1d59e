// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace proofmass {

// How many rows equal an earlier row in every one of the columns, which have `rows` finite numbers each. Zero
// equals minus zero.
[[nodiscard]] std::size_t count_repeats(std::size_t rows,
                                        std::span<const std::vector<double>* const> columns);

}  // namespace proofmass
