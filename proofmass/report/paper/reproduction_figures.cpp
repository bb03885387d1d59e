// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "proofmass/report/paper/reproduction_figures_internal.hpp"
#include "proofmass/report/text/label.hpp"
#include "proofmass/report/text/names.hpp"
#include "proofmass/report/typography.hpp"

namespace proofmass {
namespace {

// A curve of a history, or a method.
Text name_of(const std::string& curve) {
  const Text known = curve_name(curve);
  return known == same_text(curve) ? entry_name(curve) : known;
}

std::vector<Series> by_step(const std::vector<Curve>& curves) {
  constexpr std::array kMarks{Mark::line, Mark::dashes};
  std::vector<Series> series;
  for (const Curve& curve : curves) {
    Series one{.name = name_of(curve.name),
               .x = {},
               .y = curve.values,
               .mark = kMarks.at(series.size() % kMarks.size()),
               .colour = series.size(),
               .key = curve.name};
    for (std::size_t k = 0; k < curve.values.size(); ++k) one.x.push_back(static_cast<double>(k + 1));
    series.push_back(std::move(one));
  }
  return series;
}

PaperFigure curve_figure(std::string name, Text title, const Text& step, const Reproduction& made,
                         const std::vector<Curve>& curves) {
  Chart chart{.id = name,
              .title = std::move(title),
              .x = {.label = step},
              .y = {.label = text_of(Label::rmse, {{"unit", typeset_unit(made.unit)}}), .log = true},
              .series = by_step(curves)};
  return {.name = std::move(name), .chart = std::move(chart)};
}

// Textbook BP and the paper's PSO-BP.
std::vector<Curve> the_papers_two(const Reproduction& made) {
  const auto count = std::min<std::size_t>(2, made.predicted.size());
  return {made.predicted.begin(), made.predicted.begin() + static_cast<std::ptrdiff_t>(count)};
}

Chart predictions(const Reproduction& made) {
  const std::vector<Figure> unit{{"unit", typeset_unit(made.unit)}};
  Chart chart{.id = "figure-7-test-predictions",
              .title = text_of(Label::test_predictions),
              .x = {.label = text_of(Label::measured, unit)},
              .y = {.label = text_of(Label::predicted, unit)},
              .series = {}};
  for (const Curve& curve : the_papers_two(made)) {
    const std::size_t number = chart.series.size();
    chart.series.push_back({.name = name_of(curve.name),
                            .x = made.measured,
                            .y = curve.values,
                            .mark = number == 0 ? Mark::points : Mark::squares,
                            .colour = number});
  }
  return chart;
}

Chart errors(const Reproduction& made) {
  std::vector<Curve> errors = the_papers_two(made);
  for (Curve& curve : errors) {
    for (std::size_t k = 0; k < curve.values.size(); ++k) {
      curve.values[k] = made.measured[k] - curve.values[k];
    }
  }
  Chart chart{.id = "figure-8-prediction-errors",
              .title = text_of(Label::test_errors),
              .x = {.label = text_of(Label::test_row)},
              .y = {.label = text_of(Label::error, {{"unit", typeset_unit(made.unit)}})},
              .series = by_step(errors)};
  for (Series& series : chart.series) series.mark = series.colour == 0 ? Mark::points : Mark::squares;
  return chart;
}

}  // namespace

std::vector<PaperFigure> figures_of(const Reproduction& made) {
  return {curve_figure("figure-4-bp-training", text_of(Label::bp_curve), text_of(Label::epoch), made,
                       made.bp_training),
          curve_figure("figure-5-pso-bp-training", text_of(Label::pso_bp_curve), text_of(Label::epoch), made,
                       made.swarm_training),
          curve_figure("figure-6-swarm", text_of(Label::swarm_fitness), text_of(Label::generation), made,
                       made.swarm),
          {.name = "figure-7-test-predictions", .chart = predictions(made)},
          {.name = "figure-8-prediction-errors", .chart = errors(made)}};
}

std::string figure_csv(const Chart& chart) {
  std::string out = "series,x,y\n";
  for (const Series& series : chart.series) {
    std::string name = series.key.empty() ? series.name.en : series.key;
    std::replace(name.begin(), name.end(), ',', ';');
    for (std::size_t k = 0; k < series.y.size(); ++k) {
      out += fmt::format("{},{},{}\n", name, series.x[k], series.y[k]);
    }
  }
  return out;
}

}  // namespace proofmass
