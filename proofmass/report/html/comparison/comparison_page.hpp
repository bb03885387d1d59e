// SPDX-License-Identifier: Apache-2.0
// Pieces that reports of several methods share.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/page/section.hpp"
#include "proofmass/report/shown_unit.hpp"
#include "proofmass/study/comparison.hpp"

namespace proofmass::html {

// The report of a comparison, part by part; one without data is absent.
[[nodiscard]] std::vector<Section> comparison_sections(const Comparison& comparison,
                                                       InteractiveFigures& interactive,
                                                       const std::string& date);

// A table of coefficients in the units that people speak, the columns are narrower then: a row a term, the
// truth where it is given, and a column a method.
[[nodiscard]] std::string coefficients_table(const Text& caption, std::span<const Term> terms,
                                             const std::vector<Contestant>& contestants,
                                             const StaticModel* truth, const Text& truth_name,
                                             Table::Caption shown = Table::Caption::shown);

// The unit that suits the least of the methods' errors; its factor is from the declared unit.
[[nodiscard]] ShownUnit error_unit(const Comparison& comparison);

// The first run's results.
[[nodiscard]] const Identification& first_result(const Contestant& contestant);

// "2.70 × 10⁻³ ± 1.1 × 10⁻⁴"; a dash where there is none.
[[nodiscard]] std::string spread_cell(const Spread& spread, int digits);
[[nodiscard]] std::string spread_cell(const std::optional<Spread>& spread, int digits);
// With the same decimals for both, "2.704 ± 0.011", in another unit: times a factor.
[[nodiscard]] std::string plus_minus_cell(const Spread& spread, double factor = 1.0);
[[nodiscard]] std::string plus_minus_cell(const std::optional<Spread>& spread);
[[nodiscard]] std::string number_cell(const std::optional<double>& value, int digits = 3);
[[nodiscard]] std::string count_cell(double count);
[[nodiscard]] std::string count_cell(const std::optional<Spread>& count);
[[nodiscard]] std::string determination_cell(const std::optional<Spread>& r2);

}  // namespace proofmass::html
