// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/implausible_outputs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace proofmass {
namespace {

constexpr std::size_t kLeastRowsToCompare = 8;
constexpr double kMostOutputs = 0.8;     // of the rows, that the others are compared with
constexpr double kTimesOutput = 15.0;    // what they have at most, of an output that is none
constexpr double kTimesInput = 2.0;      // likewise, of an input that an output may go with
constexpr double kMostSigmas = 0.9;      // of the rows, likewise
constexpr double kTimesSigma = 1e3;      // what they have, of an uncertainty that is none
constexpr double kTimesNoSigma = 100.0;  // likewise, of one that may be: a meter has ranges

// The value below which that part of them lies.
double quantile(std::vector<double> values, double part) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::vector<double> sizes_along(const std::vector<double>& values) {
  std::vector<double> sizes;
  sizes.reserve(values.size());
  for (const double value : values) sizes.push_back(std::abs(value));
  return sizes;
}

// The largest that is not followed by one many times as large, of the sizes in ascending order; the last
// where none is.
double largest_plausible(std::vector<double> sizes) {
  const auto first =
      sizes.begin() + static_cast<std::ptrdiff_t>(kMostOutputs * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), first, sizes.end());
  const double greatest = *std::max_element(first, sizes.end());
  if (!(greatest > kTimesOutput * *first)) return greatest;
  std::sort(first, sizes.end());
  const auto gap = std::adjacent_find(
      first, sizes.end(), [](double below, double above) { return above > kTimesOutput * below; });
  return gap == sizes.end() ? greatest : *gap;
}

// Whether one of the rows has an input that none of the others comes near: then its output may be right.
bool inputs_ask_for(const Dataset& record, const std::vector<std::size_t>& far) {
  const std::vector<Axis> axes = record.axes();
  return std::any_of(axes.begin(), axes.end(), [&](Axis axis) {
    const std::vector<double> sizes = sizes_along(record.along(axis));
    double others = 0.0;
    double own = 0.0;
    for (std::size_t row = 0; row < sizes.size(); ++row) {
      double& largest = std::binary_search(far.begin(), far.end(), row) ? own : others;
      largest = std::max(largest, sizes[row]);
    }
    return own > kTimesInput * others;
  });
}

// The rows above `far`; none where one is between.
std::vector<std::size_t> rows_above(const std::vector<double>& values, double near, double far) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (values[row] <= near) continue;
    if (!(values[row] > far)) return {};
    rows.push_back(row);
  }
  return rows;
}

// The rows with an uncertainty of another order: far above nearly all others, or far below.
std::vector<std::size_t> rows_of_far_sigma(const std::vector<double>& sigma, bool above) {
  std::vector<double> values(sigma);
  if (!above) {
    for (double& value : values) value = 1.0 / value;
  }
  const double usual = quantile(values, kMostSigmas);
  return rows_above(values, kTimesNoSigma * usual, kTimesSigma * usual);
}

}  // namespace

std::optional<Finding> find_far_output(const Dataset& record) {
  if (record.rows() < kLeastRowsToCompare || !record.has(Axis::input)) return std::nullopt;
  const std::vector<double> outputs = sizes_along(record.output);
  const double plausible = largest_plausible(outputs);
  const std::vector<std::size_t> far = rows_above(outputs, plausible, plausible);
  if (far.empty() || !(plausible > 0.0) || inputs_ask_for(record, far)) return std::nullopt;
  return Finding{.code = Code::output_far_off,
                 .severity = Severity::warning,
                 .lines = record.lines_of(far),
                 .figures = {{"count", far.size()},
                             {"line", record.line_of(far.front())},
                             {"value", record.output[far.front()] / record.output_unit.to_canonical},
                             {"unit", record.output_unit.symbol},
                             {"limit", kTimesOutput}}};
}

std::optional<Finding> find_far_sigma(const Dataset& record) {
  const std::vector<double>& sigma = record.output_sigma;
  if (sigma.size() < kLeastRowsToCompare) return std::nullopt;
  const auto [least, greatest] = std::minmax_element(sigma.begin(), sigma.end());
  if (!(*least > 0.0) || *greatest < kTimesSigma * *least) return std::nullopt;
  bool above = true;
  std::vector<std::size_t> far = rows_of_far_sigma(sigma, above);
  if (far.empty()) far = rows_of_far_sigma(sigma, above = false);
  if (far.empty()) return std::nullopt;
  const double to_declared = 1.0 / std::abs(record.output_unit.to_canonical);
  return Finding{.code = Code::sigma_output_far_off,
                 .severity = Severity::warning,
                 .lines = record.lines_of(far),
                 .figures = {{"count", far.size()},
                             {"line", record.line_of(far.front())},
                             {"value", sigma[far.front()] * to_declared},
                             {"others", quantile(sigma, 0.5) * to_declared},
                             {"unit", record.output_unit.symbol},
                             {"weight", std::string(above ? "none" : "all")}}};
}

}  // namespace proofmass
