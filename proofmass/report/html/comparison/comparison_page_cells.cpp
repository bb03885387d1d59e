// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "proofmass/report/coefficient_text.hpp"
#include "proofmass/report/html/comparison/comparison_page.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/text/names.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass::html {

const Identification& first_result(const Contestant& contestant) {
  return contestant.runs.front().identification;
}

namespace {

std::string reading_of(const Contestant& contestant, Term term) {
  const Identification& result = first_result(contestant);
  for (const Coefficient& c : result.coefficients) {
    if (c.term != term) continue;
    if (!c.identified) return both(text_of(c.left_out ? Label::left_out : Label::unidentifiable));
    return in_print(readable_number(c, result.output_unit));
  }
  return "–";
}

std::string true_reading(const StaticModel& truth, Term term, const Unit& output) {
  Coefficient coefficient;
  coefficient.term = term;
  coefficient.value = truth.coefficient(term);
  return in_print(readable_number(coefficient, output));
}

}  // namespace

std::string coefficients_table(const Text& caption, std::span<const Term> terms,
                               const std::vector<Contestant>& contestants, const StaticModel* truth,
                               const Text& truth_name, Table::Caption shown) {
  const Unit& output = first_result(contestants.front()).output_unit;
  std::vector<Column> columns{{text_of(Label::term), Align::left}, {text_of(Label::unit), Align::left}};
  if (truth != nullptr) columns.push_back({truth_name});
  for (const Contestant& contestant : contestants) columns.push_back({entry_name(contestant.method)});
  Table table(caption, std::move(columns), shown);
  for (const Term term : terms) {
    const bool deviation = output.is_acceleration() && term == Term::Ki;
    std::vector<std::string> cells{escaped(deviation ? "Ki − 1" : std::string(name(term))),
                                   escaped(typeset_unit(reading_unit(term, output)))};
    if (truth != nullptr) cells.push_back(true_reading(*truth, term, output));
    for (const Contestant& contestant : contestants) cells.push_back(reading_of(contestant, term));
    table.add(std::move(cells));
  }
  return table.html();
}

ShownUnit error_unit(const Comparison& comparison) {
  double least = std::numeric_limits<double>::infinity();
  for (const Contestant& c : comparison.contestants) {
    for (const auto& part : {c.train, c.test})
      if (part && part->rmse.mean > 0.0) least = std::min(least, part->rmse.mean);
  }
  return shown_from_declared(first_result(comparison.contestants.front()).output_unit, least);
}

std::string spread_cell(const Spread& spread, int digits) {
  const std::string mean = in_print(significant_text(spread.mean, digits));
  return spread.sd ? fmt::format("{} ± {}", mean, in_print(significant_text(*spread.sd, 2))) : mean;
}

std::string spread_cell(const std::optional<Spread>& spread, int digits) {
  return spread ? spread_cell(*spread, digits) : "–";
}

std::string plus_minus_cell(const Spread& spread, double factor) {
  constexpr int kDigits = 5;
  if (!spread.sd) return in_print(significant_text(factor * spread.mean, kDigits));
  return in_print(plus_minus_text(factor * spread.mean, factor * *spread.sd));
}

std::string plus_minus_cell(const std::optional<Spread>& spread) {
  return spread ? plus_minus_cell(*spread) : "–";
}

std::string number_cell(const std::optional<double>& value, int digits) {
  return value ? in_print(significant_text(*value, digits)) : "–";
}

std::string count_cell(double count) { return fmt::format("{:.0f}", count); }

std::string count_cell(const std::optional<Spread>& count) {
  if (!count) return "–";
  return count->sd && *count->sd > 0.0 ? fmt::format("{:.0f} ± {:.0f}", count->mean, *count->sd)
                                       : count_cell(count->mean);
}

std::string determination_cell(const std::optional<Spread>& r2) {
  return r2 ? in_print(determination_text(r2->mean)) : "–";
}

}  // namespace proofmass::html
