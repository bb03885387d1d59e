// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "proofmass/report/html/page/findings.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/html/sections/parts_internal.hpp"
#include "proofmass/report/html/sections/sections.hpp"
#include "proofmass/report/number_text.hpp"
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

bool is_of_swarm(const Curve& curve) {
  return curve.name.starts_with("swarm_") || curve.name.starts_with("fish_");
}

Series numbered(const Curve& curve, std::size_t number) {
  Series series = series_of(
      curve, {curve.name, Label::fitness, number == 0 ? Mark::line : Mark::dashes, number % 6}, 1.0);
  series.name = curve_name(curve.name);
  return series;
}

Chart swarm_chart(const Identification& result) {
  Chart chart{.id = "swarm",
              .title = text_of(Label::swarm_curve),
              .x = {.label = text_of(Label::iteration)},
              .y = {.label = text_of(Label::fitness, {{"unit", typeset_unit(result.output_unit.symbol)}}),
                    .log = true},
              .series = {}};
  for (const Curve& curve : result.history) {
    if (is_of_swarm(curve) && !curve.values.empty())
      chart.series.push_back(numbered(curve, chart.series.size()));
  }
  return chart;
}

// The course of another search or iteration: each by its own name, for they have nothing in common.
Chart course_chart(const Curve& curve, std::size_t number) {
  const auto [least, largest] = std::minmax_element(curve.values.begin(), curve.values.end());
  constexpr double kLogFrom = 10.0;
  const Text name = curve_name(curve.name);
  Chart chart{.id = "course-" + std::to_string(number),
              .title = name,
              .x = {.label = text_of(Label::step)},
              .y = {.label = name, .log = *least > 0.0 && *largest > kLogFrom * *least},
              .series = {numbered(curve, 0)}};
  for (double& x : chart.series.front().x) x += 1.0;
  chart.series.front().name = {};
  return chart;
}

// The sizes of hidden layer that were tried.
std::string trials_table(const Identification& result) {
  const auto* const network = std::get_if<NetworkDetails>(&result.details);
  if (network == nullptr || network->hidden_search.empty()) return {};
  Table table(text_of(Label::hidden_trials, {{"unit", typeset_unit(result.output_unit.symbol)}}),
              {{text_of(Label::hidden)},
               {text_of(Label::mean)},
               {text_of(Label::least)},
               {text_of(Label::spread)},
               {same_text(""), Align::left}});
  for (const HiddenTrial& trial : network->hidden_search) {
    table.add({std::to_string(trial.hidden), in_print(significant_text(trial.mean, 5)),
               in_print(significant_text(trial.best, 5)), in_print(significant_text(trial.spread, 3)),
               trial.chosen ? both(text_of(Label::chosen)) : ""});
  }
  return table.html();
}

std::optional<Section> training_section(const IdentificationContext& context) {
  const Identification& result = context.run.identification;
  std::vector<Chart> charts{training_chart(result), swarm_chart(result)};
  for (const Curve& curve : result.history) {
    const bool training = std::any_of(kTrainingCurves.begin(), kTrainingCurves.end(),
                                      [&](const Known& known) { return known.name == curve.name; });
    if (!training && !is_of_swarm(curve) && !curve.values.empty())
      charts.push_back(course_chart(curve, charts.size()));
  }
  std::string figures;
  for (const Chart& chart : charts)
    if (!chart.series.empty()) figures += figure(chart, context.interactive);
  const std::string trials = trials_table(result);
  if (figures.empty() && trials.empty()) return std::nullopt;
  return Section{.id = "training",
                 .title = Label::training,
                 .body = element("div", figures, "class=\"figures\"") + trials,
                 .short_ = true};
}

}  // namespace

extern const PageSection training_part;
const PageSection training_part{.place = 80, .make = &training_section};

}  // namespace proofmass::html
