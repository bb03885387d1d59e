// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace proofmass {

// How many shares a pass over so many rows is made in: a number that depends on the rows alone, so that sums
// do not depend on the number of threads, and that has a limit, so that memory does not grow with the rows.
[[nodiscard]] std::size_t row_shares(std::size_t rows) noexcept;

// Calls body(share, first, last) for every share, in parallel; shares begin at multiples of RowBlock::kRows.
void for_each_row_share(std::size_t rows,
                        const std::function<void(std::size_t, std::size_t, std::size_t)>& body);

}  // namespace proofmass
