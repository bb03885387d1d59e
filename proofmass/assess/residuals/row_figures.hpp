// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/run.hpp"

namespace proofmass {

// Figures of each row of a record beside a fit to some of its rows. One value a row; in the output's
// canonical unit where they have one.
struct RowFigures {
  std::vector<Part> parts;
  std::vector<double> predicted;
  std::vector<double> residuals;  // measured minus predicted
  // Influence of the rows that were fitted, NaN for the others; empty for a fit that is not
  // least squares with known weights. The leverage is the diagonal of the hat matrix, the studentised
  // residual the residual over its own standard deviation, and Cook's distance D = t² h / ((1 - h) p) for p
  // coefficients (Cook, Technometrics 19, 1977).
  std::vector<double> leverage, studentised, cooks_distance;
};

// `split`: of the record's rows, as the fit was made from them. Throws bad data when the record lacks an axis
// that the fit used.
[[nodiscard]] RowFigures row_figures(const Dataset& record, const Split& split, const Identification& result);

}  // namespace proofmass
