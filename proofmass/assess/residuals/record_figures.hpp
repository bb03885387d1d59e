// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "proofmass/assess/residuals/distribution.hpp"
#include "proofmass/assess/residuals/row_figures.hpp"
#include "proofmass/core/dataset.hpp"

namespace proofmass {

// What a report shows of the rows of a record beside a fit to some of them. Of a long record some rows are
// drawn, with all extremes; whatever is counted is counted over all of them.
struct RecordFigures {
  Dataset record;                       // the rows that are drawn, with the lines that they came from
  RowFigures rows;                      // of those
  std::vector<std::size_t> numbers;     // of those, among all rows, from 0
  std::vector<std::size_t> test_ranks;  // of those for testing, among all rows for testing, from 1
  std::size_t total_rows = 0;
  Histogram histogram;                        // of the residuals of all rows that were fitted
  NormalQuantiles quantiles;                  // of the same
  std::vector<std::size_t> most_influential;  // places in `rows`, largest Cook's distance first; at most ten
};

// Throws bad data when the record lacks an axis that the fit used.
[[nodiscard]] RecordFigures record_figures(const Dataset& record, const Split& split,
                                           const Identification& result);

}  // namespace proofmass
