// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/residual_trend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/assess/diagnosis/fit/joint_departure.hpp"
#include "proofmass/assess/diagnosis/record/term_space.hpp"

namespace proofmass {
namespace {

constexpr double kUnlikelyTrend = 2e-5;  // of each of at most eighteen trends of a clean record
constexpr double kLeastTrendLeft =
    1e-4;  // of a trend's square: less lies within the terms, and is not judged

using RowColumns = std::vector<std::vector<double>>;

// What trends are sought along: a value a row, and the codes of an output and a scale factor that follow it.
struct Followed {
  std::vector<double> values;
  Code output = Code::verbatim;
  Code scale_factor = Code::verbatim;
};

struct Trend {
  Code code = Code::verbatim;
  Departure departure;
  double change = 0.0;     // over the record: of the output, or of the scale factor, in canonical units
  RowColumns polynomials;  // that it is one of
};

// Legendre polynomials of degree 1 to 3 of the values, mapped to [-1, 1]; none of values that are all alike.
RowColumns polynomials_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (!(*high > *low)) return {};
  RowColumns polynomials(3, std::vector<double>(values.size()));
  for (std::size_t row = 0; row < values.size(); ++row) {
    const double x = 2.0 * (values[row] - *low) / (*high - *low) - 1.0;
    polynomials[0][row] = x;
    polynomials[1][row] = 1.5 * x * x - 0.5;
    polynomials[2][row] = (2.5 * x * x - 1.5) * x;
  }
  return polynomials;
}

Trend trend_along(const FittedRows& rows, const std::vector<double>& column, double range, Code code) {
  const std::vector<double> beyond = rows.beyond_terms(column);
  const double size = sum_of_squares(beyond);
  if (!(size > kLeastTrendLeft * sum_of_squares(column))) return {};
  const double slope = dot(beyond, rows.residuals()) / size;
  return {.code = code,
          .departure = rows.departure(beyond),
          .change = std::abs(slope) * range,
          .polynomials = {}};
}

bool is_stronger(const Trend& a, const Trend& b) {
  return std::abs(a.departure.errors) > std::abs(b.departure.errors);
}

// The most significant trend of the output, or of the scale factor where `factor` has Ai, one a row.
Trend strongest_trend(const FittedRows& rows, const RowColumns& polynomials,
                      const std::vector<double>& factor, Code code) {
  Trend strongest;
  RowColumns columns = polynomials;
  for (std::size_t degree = 0; degree < columns.size(); ++degree) {
    const auto [least, greatest] = std::minmax_element(columns[degree].begin(), columns[degree].end());
    const double range = *greatest - *least;
    for (std::size_t row = 0; row < factor.size(); ++row) columns[degree][row] *= factor[row];
    const Trend trend = trend_along(rows, columns[degree], range, code);
    if (is_stronger(trend, strongest)) strongest = trend;
  }
  strongest.polynomials = std::move(columns);
  return strongest;
}

bool is_monotone(const std::vector<double>& values) {
  if (values.front() == values.back()) return false;
  return std::is_sorted(values.begin(), values.end()) || std::is_sorted(values.rbegin(), values.rend());
}

std::vector<Followed> quantities_of(const FittedRows& rows) {
  const Dataset& record = rows.record();
  const std::vector<Axis> axes = record.axes();
  const bool by_input =
      std::any_of(axes.begin(), axes.end(), [&](Axis axis) { return is_monotone(record.along(axis)); });
  std::vector<Followed> quantities;
  if (!record.time.empty())
    quantities.push_back({record.time, Code::residuals_follow_time, Code::scale_factor_follows_time});
  if (!record.temperature.empty()) {
    quantities.push_back(
        {record.temperature, Code::residuals_follow_temperature, Code::scale_factor_follows_temperature});
  }
  // The error of an input is part of the place of its row, and of its residual.
  if (by_input && rows.inputs_uncertain())
    std::erase_if(quantities, [](const Followed& quantity) { return is_monotone(quantity.values); });
  if (!by_input && (record.time.empty() || !std::is_sorted(record.time.begin(), record.time.end()))) {
    std::vector<double> order(record.rows());
    std::iota(order.begin(), order.end(), 0.0);
    quantities.push_back({std::move(order), Code::residuals_follow_order, Code::scale_factor_follows_order});
  }
  return quantities;
}

Finding finding_of(const FittedRows& rows, const Trend& trend, bool of_output) {
  const Unit& unit = rows.record().output_unit;
  const double to_declared = 1.0 / std::abs(unit.to_canonical);
  return {.code = trend.code,
          .severity = Severity::warning,
          .figures = {{"course", std::string(of_output ? "gradual" : "factor_gradual")},
                      {"change", trend.change * to_declared},
                      {"unit", unit.symbol + (of_output ? "" : "/g")},
                      {"scale", rows.scale() * to_declared},
                      {"errors", std::abs(trend.departure.errors)}}};
}

}  // namespace

std::optional<ResidualEffect> find_residual_trend(const FittedRows& rows) {
  Trend trend;
  bool of_output = true;
  for (const Followed& quantity : quantities_of(rows)) {
    const RowColumns polynomials = polynomials_of(quantity.values);
    const auto consider = [&](const std::vector<double>& factor, Code code, bool output) {
      Trend found = strongest_trend(rows, polynomials, factor, code);
      if (!is_stronger(found, trend)) return;
      trend = std::move(found);
      of_output = output;
    };
    consider({}, quantity.output, true);
    if (rows.record().has(Axis::input))
      consider(rows.record().along(Axis::input), quantity.scale_factor, false);
  }
  if (!(trend.departure.probability < kUnlikelyTrend)) return std::nullopt;
  return ResidualEffect{.finding = finding_of(rows, trend, of_output),
                        .errors = std::abs(trend.departure.errors),
                        .columns = columns_beyond(rows, trend.polynomials, kLeastTrendLeft).orthonormal};
}

}  // namespace proofmass
