// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/parts_internal.hpp"
#include "proofmass/report/html/sections/sections.hpp"

namespace proofmass::html {
namespace {

Chart histogram_of(const Histogram& histogram, const ShownUnit& unit) {
  Series steps{.name = text_of(Label::observed), .x = {}, .y = {}, .mark = Mark::steps};
  Series normal{.name = text_of(Label::normal),
                .x = {},
                .y = histogram.normal_heights,
                .mark = Mark::dashes,
                .colour = 1};
  for (std::size_t k = 0; k <= histogram.counts.size(); ++k) {
    const double edge = histogram.low + histogram.width * static_cast<double>(k);
    steps.x.push_back(unit.factor * edge);
    if (k == histogram.counts.size()) break;
    steps.y.push_back(static_cast<double>(histogram.counts[k]));
    normal.x.push_back(unit.factor * (edge + 0.5 * histogram.width));
  }
  return {.id = "histogram",
          .title = text_of(Label::histogram),
          .x = {.label = text_of(Label::residual, {{"unit", unit.symbol}})},
          .y = {.label = text_of(Label::bin_count)},
          .series = {steps, normal}};
}

Chart quantile_chart(const RecordFigures& record, const ShownUnit& unit) {
  const NormalQuantiles& q = record.quantiles;
  Series line{.name = text_of(Label::normal_line), .x = {}, .y = {}, .mark = Mark::dashes, .colour = 1};
  for (const double z : {q.expected.front(), q.expected.back()}) {
    line.x.push_back(z);
    line.y.push_back(unit.factor * (record.histogram.mean + record.histogram.sd * z));
  }
  return {.id = "quantiles",
          .title = text_of(Label::quantile_plot),
          .x = {.label = text_of(Label::expected_quantile)},
          .y = {.label = text_of(Label::ordered_residual, {{"unit", unit.symbol}})},
          .series = {{.name = text_of(Label::observed),
                      .x = q.expected,
                      .y = scaled(q.observed, unit.factor),
                      .mark = Mark::points},
                     line}};
}

std::optional<Section> distribution_section(const IdentificationContext& context) {
  if (context.record == nullptr || context.record->histogram.counts.empty()) return std::nullopt;
  const ShownUnit unit = residual_unit(context);
  const auto& findings = context.run.identification.findings;
  const std::string figures = figure(histogram_of(context.record->histogram, unit), context.interactive,
                                     findings_of(findings, "histogram")) +
                              figure(quantile_chart(*context.record, unit), context.interactive);
  return Section{.id = "distribution",
                 .title = Label::distribution,
                 .body = element("div", figures, "class=\"figures\""),
                 .short_ = true};
}

}  // namespace

extern const PageSection distribution_part;
const PageSection distribution_part{.place = 60, .make = &distribution_section};

}  // namespace proofmass::html
