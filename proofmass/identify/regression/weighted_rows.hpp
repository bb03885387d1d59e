// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "proofmass/core/dataset.hpp"
#include "proofmass/identify/model/identifiability.hpp"

namespace proofmass {

// Rows whose weight is below this fraction of the largest tell nothing: their square roots are the factors of
// the rows, and 1e-8 of the scale is where rows begin to vanish in the rounding of the others.
inline constexpr double kNoWeight = 1e-16;

// The number of rows that tell something.
[[nodiscard]] std::size_t count_rows_with_weight(std::span<const double> weights);

// What `found` becomes when rows without weight are left out: itself when the others still identify every
// term. Otherwise throws a refusal that names each term that they cannot identify, or, when the policy is
// drop, moves it to the unidentified ones. Throws a refusal too when the rows with weight are not one more
// than the terms that are left. `weights`: one a row, not negative.
[[nodiscard]] Identifiability require_identifiable_by_weight(const Dataset& data,
                                                             const Identifiability& found,
                                                             std::span<const double> weights,
                                                             RankLossPolicy policy);

}  // namespace proofmass
