// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/comparison/comparison_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "proofmass/report/html/comparison/comparison_page.hpp"
#include "proofmass/report/html/page/html.hpp"
#include "proofmass/report/text/names.hpp"
#include "proofmass/report/typography.hpp"
#include "proofmass/study/deviations.hpp"

namespace proofmass::html {
namespace {

constexpr std::size_t kColours = 6;

// Errors of less than a few times one another are read on a linear scale.
constexpr double kLogRatio = 5.0;

// The axis of the test errors of all methods, in the unit that suits them.
struct ErrorAxis {
  ShownUnit unit;  // from the declared unit
  ChartAxis axis;
};

std::vector<double> test_errors(const Contestant& contestant) {
  std::vector<double> errors;
  for (const Run& run : contestant.runs)
    if (run.identification.test) errors.push_back(run.identification.test->rmse);
  return errors;
}

ErrorAxis error_axis(const Comparison& comparison) {
  double least = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (const Contestant& contestant : comparison.contestants) {
    for (const double error : test_errors(contestant)) {
      least = std::min(least, error);
      largest = std::max(largest, error);
    }
  }
  ShownUnit unit = error_unit(comparison);
  ChartAxis axis{.label = text_of(Label::test_rmse, {{"unit", unit.symbol}}),
                 .log = largest > kLogRatio * least};
  return {.unit = std::move(unit), .axis = std::move(axis)};
}

// Twelve methods differ in mark or colour.
Mark mark_of(std::size_t method) {
  return (method + method / kColours) % 2 == 0 ? Mark::points : Mark::squares;
}

std::string in_grid(const std::string& figures) { return element("div", figures, "class=\"figures\""); }

}  // namespace

std::string deviation_figure(const Comparison& comparison, InteractiveFigures& interactive) {
  const Deviations found = deviations(comparison);
  if (found.methods.empty()) return {};
  const std::vector<Figure> method{{"method", found.reference}};
  Chart chart{
      .id = "deviations",
      .title = found.from_truth ? text_of(Label::against_truth) : text_of(Label::against_first, method),
      .x = {.label = text_of(Label::term), .categories = {}},
      .y = {.label = found.from_truth ? text_of(Label::error_in_errors)
                                      : text_of(Label::difference_in_errors, method)},
      .series = {},
      .guides = {{.at = 0.0}}};
  for (const Term term : found.terms) chart.x.categories.push_back(same_text(std::string(name(term))));
  const auto methods = static_cast<double>(found.methods.size());
  for (std::size_t m = 0; m < found.methods.size(); ++m) {
    Series series{.name = entry_name(found.methods[m]),
                  .x = {},
                  .y = found.in_errors[m],
                  .mark = mark_of(m),
                  .colour = m % kColours};
    const double shift = 0.6 * ((static_cast<double>(m) + 0.5) / methods - 0.5);
    for (std::size_t k = 0; k < series.y.size(); ++k) series.x.push_back(static_cast<double>(k) + shift);
    if (found.from_truth) series.whisker = found.half_widths[m];
    const bool any = std::any_of(series.y.begin(), series.y.end(), [](double v) { return std::isfinite(v); });
    if (any) chart.series.push_back(std::move(series));
  }
  if (chart.series.empty()) return {};
  return paragraph(found.from_truth ? text_of(Label::against_truth_text)
                                    : text_of(Label::against_first_text, method)) +
         in_grid(figure(chart, interactive));
}

std::string repeats_figure(const Comparison& comparison, InteractiveFigures& interactive) {
  constexpr std::size_t kLeastRepeats = 3;
  const ErrorAxis shown = error_axis(comparison);
  BoxPlot plot{.id = "repeats", .title = text_of(Label::errors_by_repeat), .y = shown.axis, .boxes = {}};
  for (const Contestant& contestant : comparison.contestants) {
    const std::vector<double> errors = test_errors(contestant);
    if (errors.size() < kLeastRepeats) continue;
    const FiveNumbers five = five_numbers(scaled(errors, shown.unit.factor));
    plot.boxes.push_back({.name = same_text(contestant.method),
                          .low = five.low,
                          .lower = five.lower,
                          .median = five.median,
                          .upper = five.upper,
                          .high = five.high,
                          .beyond = five.beyond});
  }
  return plot.boxes.empty() ? std::string() : in_grid(figure(plot, interactive));
}

std::string time_figure(const Comparison& comparison, InteractiveFigures& interactive) {
  const ErrorAxis shown = error_axis(comparison);
  Chart chart{.id = "time-error",
              .title = text_of(Label::time_against_error),
              .x = {.label = text_of(Label::time_axis), .log = true},
              .y = shown.axis,
              .series = {}};
  for (const Contestant& contestant : comparison.contestants) {
    const std::vector<double> errors = test_errors(contestant);
    if (errors.size() != contestant.seconds.size() || errors.empty()) continue;
    chart.series.push_back({.name = same_text(contestant.method),
                            .x = contestant.seconds,
                            .y = scaled(errors, shown.unit.factor),
                            .mark = mark_of(chart.series.size()),
                            .colour = chart.series.size() % kColours});
  }
  return chart.series.empty() ? std::string() : in_grid(figure(chart, interactive));
}

}  // namespace proofmass::html
