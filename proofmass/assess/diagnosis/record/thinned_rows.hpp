// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace proofmass {

// Rows that a search for patterns looks at: what shows in none of so many does not matter.
inline constexpr std::size_t kMostDiagnosedRows = 20'000;
// Enough for what nearly all rows show.
inline constexpr std::size_t kSampledRows = 2000;

// The numbers 0 … rows - 1, or `most` of them, ascending: one of each equal stretch, at a place drawn for the
// stretch (always the same), so that set-ups that repeat are not met in step.
[[nodiscard]] std::vector<std::size_t> thinned_rows(std::size_t rows, std::size_t most = kMostDiagnosedRows);

}  // namespace proofmass
