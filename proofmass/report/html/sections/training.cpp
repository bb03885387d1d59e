// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/parts_internal.hpp"
#include "proofmass/report/html/sections/sections.hpp"
#include "proofmass/report/text/names.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass::html {
namespace {

// A curve by its name in a result.
struct Known {
  std::string_view name;
  Label label;
  Mark mark;
  std::size_t colour;
};
constexpr std::array kTrainingCurves{Known{"training_rmse", Label::train, Mark::line, 0},
                                     Known{"validation_rmse", Label::validation, Mark::dashes, 2},
                                     Known{"test_rmse", Label::test, Mark::dashes, 1}};

Series series_of(const Curve& curve, const Known& known, double factor) {
  Series made{.name = text_of(known.label),
              .x = {},
              .y = scaled(curve.values, factor),
              .mark = known.mark,
              .colour = known.colour};
  for (std::size_t k = 0; k < curve.values.size(); ++k) made.x.push_back(static_cast<double>(k));
  return made;
}

// The one with the least error on the rows that decide when to stop.
std::optional<std::size_t> chosen_epoch(const std::vector<Curve>& curves) {
  for (const Curve& curve : curves) {
    if (curve.name != "validation_rmse" || curve.values.empty()) continue;
    return static_cast<std::size_t>(std::min_element(curve.values.begin(), curve.values.end()) -
                                    curve.values.begin());
  }
  return std::nullopt;
}

Chart training_chart(const Identification& result) {
  const ShownUnit unit{1.0, typeset_unit(result.output_unit.symbol)};
  Chart chart{.id = "training",
              .title = text_of(Label::training_curve),
              .x = {.label = text_of(Label::epoch)},
              .y = {.label = text_of(Label::rmse, {{"unit", unit.symbol}}), .log = true},
              .series = {}};
  for (const Known& known : kTrainingCurves) {
    for (const Curve& curve : result.history)
      if (curve.name == known.name) chart.series.push_back(series_of(curve, known, unit.factor));
  }
  if (const auto epoch = chosen_epoch(result.history)) {
    chart.guides.push_back({.at = static_cast<double>(*epoch),
                            .vertical = true,
                            .label = text_of(Label::chosen_epoch, {{"epoch", *epoch}})});
  }
  return chart;
}

// Whatever is no curve of training: the swarm's, or a search's, each by its name.
Chart search_chart(const Identification& result) {
  Chart chart{.id = "swarm",
              .title = text_of(Label::swarm_curve),
              .x = {.label = text_of(Label::iteration)},
              .y = {.label = text_of(Label::fitness, {{"unit", typeset_unit(result.output_unit.symbol)}}),
                    .log = true},
              .series = {}};
  for (const Curve& curve : result.history) {
    const bool training = std::any_of(kTrainingCurves.begin(), kTrainingCurves.end(),
                                      [&](const Known& known) { return known.name == curve.name; });
    if (training || curve.values.empty()) continue;
    Known known{curve.name, Label::fitness, chart.series.empty() ? Mark::line : Mark::dashes,
                chart.series.size() % 6};
    Series series = series_of(curve, known, 1.0);
    series.name = curve_name(curve.name);
    chart.series.push_back(std::move(series));
  }
  return chart;
}

std::optional<Section> training_section(const IdentificationContext& context) {
  std::string figures;
  for (const Chart& chart :
       {training_chart(context.run.identification), search_chart(context.run.identification)}) {
    if (!chart.series.empty()) figures += figure(chart, context.interactive);
  }
  if (figures.empty()) return std::nullopt;
  return Section{.id = "training",
                 .title = Label::training,
                 .body = element("div", figures, "class=\"figures\""),
                 .short_ = true};
}

}  // namespace

extern const PageSection training_part;
const PageSection training_part{.place = 80, .make = &training_section};

}  // namespace proofmass::html
