// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/parts_internal.hpp"
#include "proofmass/report/html/sections/sections.hpp"
#include "proofmass/report/number_text.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass::html {
namespace {

std::string table_of(const IdentificationContext& context) {
  const RecordFigures& record = *context.record;
  const ShownUnit unit = residual_unit(context);
  Table table(text_of(Label::most_influential), {{text_of(Label::row)},
                                                 {text_of(Label::line)},
                                                 {text_of(Label::residual, {{"unit", unit.symbol}})},
                                                 {text_of(Label::studentised)},
                                                 {text_of(Label::leverage)},
                                                 {text_of(Label::cook)}});
  for (const std::size_t k : record.most_influential) {
    const auto number = [](double value) { return escaped(typeset(significant_text(value, 3))); };
    table.add({std::to_string(record.numbers[k] + 1), std::to_string(record.record.line_of(k)),
               number(unit.factor * record.rows.residuals[k]), number(record.rows.studentised[k]),
               number(record.rows.leverage[k]), number(record.rows.cooks_distance[k])});
  }
  return table.html();
}

std::optional<Section> influence_section(const IdentificationContext& context) {
  if (context.record == nullptr || context.record->rows.leverage.empty()) return std::nullopt;
  const RecordFigures& record = *context.record;
  std::vector<double> numbers;
  for (const std::size_t number : record.numbers) numbers.push_back(static_cast<double>(number + 1));
  const Chart leverage{
      .id = "leverage",
      .title = text_of(Label::leverage_plot),
      .x = {.label = text_of(Label::leverage)},
      .y = {.label = text_of(Label::studentised)},
      .series = {{.name = {}, .x = record.rows.leverage, .y = record.rows.studentised, .mark = Mark::points}},
      .guides = {{.at = 0.0}}};
  const Chart cook{
      .id = "cook",
      .title = text_of(Label::cook_plot),
      .x = {.label = text_of(Label::row)},
      .y = {.label = text_of(Label::cook)},
      .series = {{.name = {}, .x = numbers, .y = record.rows.cooks_distance, .mark = Mark::points}}};
  const std::string figures = figure(leverage, context.interactive) + figure(cook, context.interactive);
  return Section{
      .id = "influence",
      .title = Label::influence,
      .body = thinning_note(record) + element("div", figures, "class=\"figures\"") + table_of(context)};
}

}  // namespace

extern const PageSection influence_part;
const PageSection influence_part{.place = 110, .make = &influence_section};

}  // namespace proofmass::html
