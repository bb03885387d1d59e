// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "proofmass/assess/residuals/row_figures.hpp"
#include "proofmass/core/dataset.hpp"

namespace proofmass {

// Rows that a figure has room for.
inline constexpr std::size_t kMostShownRows = 4000;

// The rows to draw, ascending: all of a record of at most `most`; of a longer one evenly spaced ones, and
// besides them those with the largest residuals, the most influence and the ends of each column.
[[nodiscard]] std::vector<std::size_t> shown_rows(const Dataset& record, const RowFigures& figures,
                                                  std::size_t most = kMostShownRows);

}  // namespace proofmass
