// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/residual_trend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace proofmass {
namespace {

constexpr double kUnlikelyTrend = 2e-5;  // of each of at most nine trends of a clean record
constexpr double kLeastTrendLeft =
    1e-4;  // of a trend's square: less lies within the terms, and is not judged

struct Trend {
  Code code = Code::verbatim;
  Departure departure;
  double change = 0.0;  // of the output over the record, in its canonical unit
};

// Legendre polynomials of degree 1 to 3 at x in [-1, 1].
std::array<double, 3> polynomials(double x) { return {x, 1.5 * x * x - 0.5, (2.5 * x * x - 1.5) * x}; }

Trend trend_along(const FittedRows& rows, const std::vector<double>& polynomial, Code code) {
  const std::vector<double> beyond = rows.beyond_terms(polynomial);
  const double size = sum_of_squares(beyond);
  if (!(size > kLeastTrendLeft * sum_of_squares(polynomial))) return {};
  const double slope = std::inner_product(beyond.begin(), beyond.end(), rows.residuals().begin(), 0.0) / size;
  const auto [least, greatest] = std::minmax_element(polynomial.begin(), polynomial.end());
  return {
      .code = code, .departure = rows.departure(beyond), .change = std::abs(slope) * (*greatest - *least)};
}

// The most significant trend along a quantity that has a value in each row.
Trend strongest_trend(const FittedRows& rows, const std::vector<double>& quantity, Code code) {
  Trend strongest;
  if (quantity.size() != rows.rows()) return strongest;
  const auto [low, high] = std::minmax_element(quantity.begin(), quantity.end());
  if (!(*high > *low)) return strongest;
  for (std::size_t degree = 0; degree < 3; ++degree) {
    std::vector<double> polynomial;
    polynomial.reserve(quantity.size());
    for (const double q : quantity)
      polynomial.push_back(polynomials(2.0 * (q - *low) / (*high - *low) - 1.0)[degree]);
    const Trend trend = trend_along(rows, polynomial, code);
    if (std::abs(trend.departure.errors) > std::abs(strongest.departure.errors)) strongest = trend;
  }
  return strongest;
}

std::vector<double> row_order(std::size_t rows) {
  std::vector<double> order(rows);
  std::iota(order.begin(), order.end(), 0.0);
  return order;
}

}  // namespace

std::optional<Finding> find_residual_trend(const FittedRows& rows) {
  const Dataset& record = rows.record();
  const Trend time = strongest_trend(rows, record.time, Code::residuals_follow_time);
  const Trend temperature = strongest_trend(rows, record.temperature, Code::residuals_follow_temperature);
  const Trend order = record.time.empty() || !std::is_sorted(record.time.begin(), record.time.end())
                          ? strongest_trend(rows, row_order(rows.rows()), Code::residuals_follow_order)
                          : Trend{};
  const std::array trends{time, temperature, order};
  const Trend& trend = *std::max_element(trends.begin(), trends.end(), [](const Trend& a, const Trend& b) {
    return std::abs(a.departure.errors) < std::abs(b.departure.errors);
  });
  if (!(trend.departure.probability < kUnlikelyTrend)) return std::nullopt;
  return Finding{.code = trend.code,
                 .severity = Severity::warning,
                 .figures = {{"change", trend.change / std::abs(record.output_unit.to_canonical)},
                             {"unit", record.output_unit.symbol},
                             {"scale", rows.scale() / std::abs(record.output_unit.to_canonical)},
                             {"errors", std::abs(trend.departure.errors)}}};
}

}  // namespace proofmass
