// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/plain_response.hpp"

#include <algorithm>
#include <cmath>

#include "proofmass/assess/diagnosis/record/linear_fit.hpp"
#include "proofmass/assess/diagnosis/record/output_resolution.hpp"
#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"

namespace proofmass {
namespace {

constexpr double kLargeChange = 0.05;  // of the range of the outputs
constexpr double kTellingScales = 20.0;
constexpr double kManySteps = 4.0;
constexpr double kEdge = 0.2;           // of the range of the outputs: the rows within may be clipped
constexpr double kEnoughSpread = 0.3;   // of the range of Ai: rows within less of it say little of Ki
constexpr double kTrimmedScales = 4.0;  // scales, beyond which a row does not count for the fit
constexpr int kMostTrims = 4;
constexpr std::size_t kLeastPlainRows = 6;
constexpr std::size_t kOften = 4;  // rows with exactly one output
constexpr double kFollows = 0.02;  // of the range of the outputs

double width(const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return *greatest - *least;
}

CommonOutput most_common_output(const Dataset& record) {
  std::vector<double> outputs;
  for (const std::size_t row : thinned_rows(record.rows())) outputs.push_back(record.output[row]);
  std::sort(outputs.begin(), outputs.end());
  CommonOutput common;
  for (auto first = outputs.begin(); first != outputs.end();) {
    const auto last = std::find_if(first, outputs.end(), [first](double e) { return e != *first; });
    const auto count = static_cast<std::size_t>(last - first);
    if (count > common.count) common = {.value = *first, .count = count};
    first = last;
  }
  return common;
}

// The rows whose output is neither the largest nor the smallest, nor that of the row before, nor one that
// many others have; a sample of them.
std::vector<std::size_t> rows_above_suspicion(const Dataset& record, const CommonOutput& common) {
  const auto [least, greatest] = std::minmax_element(record.output.begin(), record.output.end());
  std::vector<std::size_t> rows;
  for (const std::size_t row : thinned_rows(record.rows())) {
    const double e = record.output[row];
    const bool held = row > 0 && e == record.output[row - 1];
    const bool frequent = common.count >= kOften && e == common.value;
    if (!held && !frequent && e != *least && e != *greatest) rows.push_back(row);
  }
  return rows;
}

// Without those near the ends of the range, where the others still tell the scale factor.
Dataset central_rows(const Dataset& record, const std::vector<std::size_t>& rows) {
  const auto [least, greatest] = std::minmax_element(record.output.begin(), record.output.end());
  const double edge = kEdge * (*greatest - *least);
  std::vector<std::size_t> central;
  for (const std::size_t row : rows) {
    if (record.output[row] > *least + edge && record.output[row] < *greatest - edge) central.push_back(row);
  }
  const Dataset chosen = record.select(central);
  const bool enough = central.size() >= kLeastPlainRows &&
                      width(chosen.along(Axis::input)) >= kEnoughSpread * width(record.along(Axis::input));
  return enough ? chosen : record.select(rows);
}

// Fits again without the rows that lie far off, until none does.
LinearFit trimmed_fit(Dataset rows) {
  LinearFit fit = fit_linear(rows);
  for (int trim = 0; trim < kMostTrims; ++trim) {
    std::vector<std::size_t> near;
    for (std::size_t row = 0; row < rows.rows(); ++row) {
      if (std::abs(fit.residuals[row]) <= kTrimmedScales * fit.scale) near.push_back(row);
    }
    if (near.size() == rows.rows() || near.size() < kLeastPlainRows) break;
    rows = rows.select(near);
    fit = fit_linear(rows);
  }
  return fit;
}

}  // namespace

double PlainResponse::telling() const {
  return std::max({kLargeChange * range, kTellingScales * scale, kManySteps * step});
}

double spread_over(const std::vector<double>& values, std::span<const std::size_t> rows) {
  double least = values[rows.front()];
  double greatest = least;
  for (const std::size_t row : rows) {
    least = std::min(least, values[row]);
    greatest = std::max(greatest, values[row]);
  }
  return greatest - least;
}

std::optional<PlainResponse> plain_response(const Dataset& record) {
  if (record.rows() < kLeastPlainRows || !record.has(Axis::input)) return std::nullopt;
  const CommonOutput common = most_common_output(record);
  const std::vector<std::size_t> rows = rows_above_suspicion(record, common);
  if (rows.size() < kLeastPlainRows) return std::nullopt;
  const LinearFit fit = trimmed_fit(central_rows(record, rows));
  if (fit.scale_factor == 0.0) return std::nullopt;
  const OutputResolution resolution = output_resolution(record);
  PlainResponse plain{.expected = {},
                      .scale_factor = std::abs(fit.scale_factor),
                      .scale = fit.scale,
                      .range = resolution.range,
                      .step = resolution.step,
                      .common = common};
  plain.expected.reserve(record.rows());
  for (std::size_t row = 0; row < record.rows(); ++row)
    plain.expected.push_back(fit.model.output(record.at(row)));
  const double near = std::max(kFollows * plain.range, kTrimmedScales * plain.scale);
  const auto follow = std::count_if(rows.begin(), rows.end(), [&](std::size_t row) {
    return std::abs(record.output[row] - plain.expected[row]) <= near;
  });
  if (2 * static_cast<std::size_t>(follow) <= rows.size()) return std::nullopt;
  return plain;
}

}  // namespace proofmass
