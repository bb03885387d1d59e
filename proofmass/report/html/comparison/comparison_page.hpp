// SPDX-License-Identifier: Apache-2.0
// Pieces that reports of several methods share.
#pragma once

#include <string>
#include <vector>

#include "proofmass/report/html/page/section.hpp"
#include "proofmass/study/comparison.hpp"

namespace proofmass::html {

// The report of a comparison, part by part; one without data is absent.
[[nodiscard]] std::vector<Section> comparison_sections(const Comparison& comparison,
                                                       InteractiveFigures& interactive);

// A coefficient of a method as a cell of a table: "13.05e-6 ± 3e-8", left out, not identifiable, or a dash.
[[nodiscard]] std::string coefficient_cell(const Contestant& contestant, Term term);

// "2.70 × 10⁻³ ± 1.1 × 10⁻⁴"; a dash where there is none.
[[nodiscard]] std::string spread_cell(const Spread& spread, int digits);
[[nodiscard]] std::string spread_cell(const std::optional<Spread>& spread, int digits);
[[nodiscard]] std::string number_cell(const std::optional<double>& value, int digits = 3);
[[nodiscard]] std::string count_cell(double count);
[[nodiscard]] std::string determination_cell(const std::optional<Spread>& r2);

}  // namespace proofmass::html
