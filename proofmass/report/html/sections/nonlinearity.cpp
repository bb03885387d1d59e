// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/residuals/nonlinearity.hpp"

#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/parts_internal.hpp"
#include "proofmass/report/html/sections/sections.hpp"

namespace proofmass::html {
namespace {

std::optional<Section> nonlinearity_section(const IdentificationContext& context) {
  const Identification& result = context.run.identification;
  const Nonlinearity found = nonlinearity_of(result);
  if (found.input.empty()) return std::nullopt;
  const ShownUnit unit = shown_unit(result.output_unit, largest_of(found.value));
  Chart chart{.id = "nonlinearity",
              .title = text_of(Label::nonlinearity_plot),
              .x = {.label = same_text("Ai, g")},
              .y = {.label = text_of(Label::nonlinearity_axis, {{"unit", unit.symbol}})},
              .series = {},
              .guides = {{.at = 0.0}}};
  if (!found.half_width.empty()) {
    Series band{.name = text_of(Label::band), .x = found.input, .y = {}, .mark = Mark::band};
    for (std::size_t k = 0; k < found.input.size(); ++k) {
      band.y.push_back(unit.factor * (found.value[k] - found.half_width[k]));
      band.high.push_back(unit.factor * (found.value[k] + found.half_width[k]));
    }
    chart.series.push_back(std::move(band));
  }
  chart.series.push_back(
      {.name = text_of(Label::nonlinearity), .x = found.input, .y = scaled(found.value, unit.factor)});
  const std::string text = paragraph(text_of(Label::nonlinearity_text, {{"names", join_names(found.terms)}}));
  return Section{.id = "nonlinearity",
                 .title = Label::nonlinearity,
                 .body = text + element("div", figure(chart, context.interactive), "class=\"figures\""),
                 .short_ = true};
}

}  // namespace

extern const PageSection nonlinearity_part;
const PageSection nonlinearity_part{.place = 70, .make = &nonlinearity_section};

}  // namespace proofmass::html
