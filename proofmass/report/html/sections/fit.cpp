// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/parts_internal.hpp"
#include "proofmass/report/html/sections/sections.hpp"

namespace proofmass::html {
namespace {

std::optional<Section> fit_section(const IdentificationContext& context) {
  if (context.record == nullptr) {
    const Text absent = text_of(Label::record_absent, "why", context.why_no_record);
    return Section{.id = "fit", .title = Label::fit, .body = paragraph(absent), .short_ = true};
  }
  const RecordFigures& record = *context.record;
  const ShownUnit unit = shown_unit(context.run.identification.output_unit, largest_of(record.record.output));
  const std::vector<Figure> symbol{{"unit", unit.symbol}};
  const std::vector<double> measured = scaled(record.record.output, unit.factor);
  Chart chart{.id = "predicted-measured",
              .title = text_of(Label::predicted_against),
              .x = {.label = text_of(Label::measured, symbol)},
              .y = {.label = text_of(Label::predicted, symbol)},
              .series = series_by_part(record, measured, scaled(record.rows.predicted, unit.factor))};
  const auto [low, high] = std::minmax_element(measured.begin(), measured.end());
  if (low != high) {
    chart.series.push_back({.name = text_of(Label::equality),
                            .x = {*low, *high},
                            .y = {*low, *high},
                            .mark = Mark::dashes,
                            .colour = 5});
  }
  std::string body = thinning_note(record);
  body += element(
      "div", figure(chart, context.interactive, findings_of(context.run.identification.findings, chart.id)),
      "class=\"figures\"");
  return Section{.id = "fit", .title = Label::fit, .body = body, .short_ = true};
}

}  // namespace

extern const PageSection fit_part;
const PageSection fit_part{.place = 40, .make = &fit_section};

}  // namespace proofmass::html
