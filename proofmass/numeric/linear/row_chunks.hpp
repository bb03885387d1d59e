// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>

namespace proofmass {

// Number of portions for a pass over `rows` rows. It depends only on the number of rows, so that sums do not
// depend on the number of threads. It is limited, so that memory does not grow with the rows.
[[nodiscard]] std::size_t row_chunks(std::size_t rows) noexcept;

// Calls body(portion, first, last) for every portion, in parallel. Portions begin at multiples of
// RowBlock::kRows.
void for_each_row_chunk(std::size_t rows,
                        const std::function<void(std::size_t, std::size_t, std::size_t)>& body);

}  // namespace proofmass
