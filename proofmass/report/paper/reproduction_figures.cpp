// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "proofmass/report/paper/reproduction_figures_internal.hpp"

namespace proofmass {
namespace {

std::vector<PlotSeries> by_step(const std::vector<Curve>& curves) {
  std::vector<PlotSeries> series;
  for (const Curve& curve : curves) {
    PlotSeries one{.name = curve.name, .x = {}, .y = curve.values};
    for (std::size_t k = 0; k < curve.values.size(); ++k) one.x.push_back(static_cast<double>(k + 1));
    series.push_back(std::move(one));
  }
  return series;
}

PaperFigure curve_figure(std::string name, std::string title, const char* step, const Reproduction& made,
                         const std::vector<Curve>& curves) {
  return {.name = std::move(name),
          .plot = {.title = std::move(title),
                   .x_label = step,
                   .y_label = fmt::format("RMSE, {}", made.unit),
                   .log_y = true,
                   .series = by_step(curves)}};
}

// Textbook BP and the paper's PSO-BP.
std::vector<Curve> the_papers_two(const Reproduction& made) {
  const auto count = std::min<std::size_t>(2, made.predicted.size());
  return {made.predicted.begin(), made.predicted.begin() + static_cast<std::ptrdiff_t>(count)};
}

Plot predictions(const Reproduction& made) {
  Plot plot{.title = "Test rows: measured and predicted output",
            .x_label = fmt::format("measured, {}", made.unit),
            .y_label = fmt::format("predicted, {}", made.unit),
            .series = {}};
  for (const Curve& curve : the_papers_two(made)) {
    plot.series.push_back({curve.name, made.measured, curve.values, SeriesStyle::points});
  }
  return plot;
}

Plot errors(const Reproduction& made) {
  std::vector<Curve> errors = the_papers_two(made);
  for (Curve& curve : errors) {
    for (std::size_t k = 0; k < curve.values.size(); ++k) {
      curve.values[k] = made.measured[k] - curve.values[k];
    }
  }
  Plot plot{.title = "Test rows: prediction errors",
            .x_label = "test row",
            .y_label = fmt::format("measured minus predicted, {}", made.unit),
            .series = by_step(errors)};
  for (PlotSeries& series : plot.series) series.style = SeriesStyle::points;
  return plot;
}

}  // namespace

std::vector<PaperFigure> figures_of(const Reproduction& made) {
  return {curve_figure("figure-4-bp-training", "BP: error by epoch", "epoch", made, made.bp_training),
          curve_figure("figure-5-pso-bp-training", "PSO-BP (paper's preset): error by epoch after the swarm",
                       "epoch", made, made.swarm_training),
          curve_figure("figure-6-swarm", "The swarm: fitness by generation", "generation", made, made.swarm),
          {.name = "figure-7-test-predictions", .plot = predictions(made)},
          {.name = "figure-8-prediction-errors", .plot = errors(made)}};
}

std::string figure_csv(const Plot& plot) {
  std::string out = "series,x,y\n";
  for (const PlotSeries& series : plot.series) {
    std::string name = series.name;
    std::replace(name.begin(), name.end(), ',', ';');
    for (std::size_t k = 0; k < series.y.size(); ++k) {
      out += fmt::format("{},{},{}\n", name, series.x[k], series.y[k]);
    }
  }
  return out;
}

}  // namespace proofmass
