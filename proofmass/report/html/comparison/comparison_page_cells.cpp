// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "proofmass/report/html/comparison/comparison_page.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/number_text.hpp"

namespace proofmass::html {
std::string coefficient_cell(const Contestant& contestant, Term term) {
  for (const Coefficient& c : contestant.runs.front().identification.coefficients) {
    if (c.term != term) continue;
    if (!c.identified) return both(text_of(c.left_out ? Label::left_out : Label::unidentifiable));
    if (!c.standard_error) return in_print(significant_text(c.value, 7));
    return fmt::format("{} ± {}", in_print(uncertain_text(c.value, c.standard_error)),
                       in_print(significant_text(*c.standard_error, 2)));
  }
  return "–";
}

std::string spread_cell(const Spread& spread, int digits) {
  const std::string mean = in_print(significant_text(spread.mean, digits));
  return spread.sd ? fmt::format("{} ± {}", mean, in_print(significant_text(*spread.sd, 2))) : mean;
}

std::string spread_cell(const std::optional<Spread>& spread, int digits) {
  return spread ? spread_cell(*spread, digits) : "–";
}

std::string number_cell(const std::optional<double>& value, int digits) {
  return value ? in_print(significant_text(*value, digits)) : "–";
}

std::string count_cell(double count) { return fmt::format("{:.0f}", count); }

std::string determination_cell(const std::optional<Spread>& r2) {
  return r2 ? in_print(determination_text(r2->mean)) : "–";
}

}  // namespace proofmass::html
