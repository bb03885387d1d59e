// SPDX-License-Identifier: Apache-2.0
// What the sections that draw rows share.
#pragma once

#include <string>
#include <vector>

#include "proofmass/report/html/page/section.hpp"
#include "proofmass/report/shown_unit.hpp"

namespace proofmass::html {

[[nodiscard]] ShownUnit residual_unit(const IdentificationContext& context);

// y over x, a series for each part of the record that has rows.
[[nodiscard]] std::vector<Series> series_by_part(const RecordFigures& record, const std::vector<double>& x,
                                                 const std::vector<double>& y);

// A paragraph that says how many rows are drawn, where it is not all of them.
[[nodiscard]] std::string thinning_note(const RecordFigures& record);

}  // namespace proofmass::html
