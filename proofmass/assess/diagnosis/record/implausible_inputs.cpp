// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/implausible_inputs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "proofmass/assess/diagnosis/record/linear_fit.hpp"
#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"
#include "proofmass/numeric/regression/robust_loss.hpp"

namespace proofmass {
namespace {

constexpr double kLargestAcceleration = 1e4;  // g; centrifuges for accelerometers end at some hundred
constexpr double kFarTemperature = 100.0;     // K from the median
constexpr std::size_t kLeastMagnitudes = 8;
constexpr double kMostRows = 0.9;         // of the rows, that have one |A|
constexpr double kMagnitudeScales = 6.0;  // of |A|, within which rows have the same
constexpr double kMagnitudeSteps = 2.0;   // of the inputs, likewise
constexpr double kSameMagnitude = 1e-9;   // of |A|, likewise where no step is known
constexpr double kUnlikeMagnitude = 5.0;  // times as far from it
constexpr double kLeastUnlike = 1e-5;     // of |A|
constexpr double kOtherLevel = 2.0;  // |A| over the others': the row may be at another level of acceleration
constexpr double kAgreesWithOutput = 0.1;  // of the difference in |A|, by which the output may miss
constexpr std::size_t kFewMistyped = 2;    // that agree with their outputs, and may be mistyped across Ai

double magnitude(const Acceleration& a) { return std::sqrt(a.i * a.i + a.o * a.o + a.p * a.p); }

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The |A| that nearly all rows have, and how far from it a row is unlike them.
struct CommonMagnitude {
  double value = 0.0;
  double unlike = 0.0;
};

std::optional<CommonMagnitude> common_magnitude(const Dataset& record) {
  std::vector<double> sizes;
  for (const std::size_t row : thinned_rows(record.rows(), kSampledRows))
    sizes.push_back(magnitude(record.at(row)));
  CommonMagnitude common{.value = median(sizes), .unlike = 0.0};
  std::vector<double> off(sizes);
  for (double& size : off) size -= common.value;
  double step = 0.0;
  for (const double s : record.acceleration_resolution) step = std::max(step, s);
  const double same = std::max(
      {kMagnitudeScales * median_scale(off, 1), kMagnitudeSteps * step, kSameMagnitude * common.value});
  const auto alike = std::count_if(off.begin(), off.end(), [same](double d) { return std::abs(d) <= same; });
  if (static_cast<double>(alike) < kMostRows * static_cast<double>(off.size())) return std::nullopt;
  common.unlike = std::max(kUnlikeMagnitude * same, kLeastUnlike * common.value);
  return common;
}

// Without rows that have one |A| together: they are at another level of acceleration.
std::vector<std::size_t> of_no_level(const Dataset& record, const std::vector<std::size_t>& rows,
                                     double tolerance) {
  std::vector<std::pair<double, std::size_t>> sizes;
  sizes.reserve(rows.size());
  for (const std::size_t row : rows) sizes.emplace_back(magnitude(record.at(row)), row);
  std::sort(sizes.begin(), sizes.end());
  std::vector<std::size_t> alone;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const bool below = k > 0 && sizes[k].first - sizes[k - 1].first < tolerance;
    const bool above = k + 1 < sizes.size() && sizes[k + 1].first - sizes[k].first < tolerance;
    if (!below && !above) alone.push_back(sizes[k].second);
  }
  std::sort(alone.begin(), alone.end());
  return alone;
}

// Without rows whose output follows their acceleration, as the others' fit has it: they may be at another
// level. One or two of nearly the others' |A| may be mistyped across the input axis, which the output does
// not show.
void leave_out_levels(const Dataset& record, const CommonMagnitude& common, const LinearFit& others,
                      std::vector<std::size_t>& rows) {
  std::vector<std::size_t> agreeing;
  std::size_t at_other_level = 0;
  for (const std::size_t row : rows) {
    const double size = magnitude(record.at(row));
    const double difference = std::abs(others.scale_factor) * std::abs(size - common.value);
    const double missed = std::abs(record.output[row] - others.model.output(record.at(row)));
    if (missed >= kAgreesWithOutput * difference) continue;
    agreeing.push_back(row);
    const bool is_mistyped_across =
        std::abs(record.along(Axis::input)[row]) <= common.value + common.unlike &&
        size < kOtherLevel * common.value && size * kOtherLevel > common.value;
    at_other_level += is_mistyped_across ? 0 : 1;
  }
  if (at_other_level == 0 && agreeing.size() <= kFewMistyped) return;
  std::erase_if(rows, [&](std::size_t row) {
    return std::find(agreeing.begin(), agreeing.end(), row) != agreeing.end();
  });
}

struct TemperatureScale {
  const char* symbol;
  double absolute_zero;
  double per_kelvin;
};
constexpr std::array kTemperatureScales{TemperatureScale{"degC", -273.15, 1.0},
                                        TemperatureScale{"K", 0.0, 1.0},
                                        TemperatureScale{"degF", -459.67, 1.8}};

// Below absolute zero, or far from all others.
std::vector<std::size_t> rows_of_no_temperature(const Dataset& record) {
  const auto scale = std::find_if(kTemperatureScales.begin(), kTemperatureScales.end(), [&](const auto& one) {
    return one.symbol == record.temperature_unit.symbol;
  });
  std::vector<std::size_t> rows;
  if (record.temperature.empty() || scale == kTemperatureScales.end()) return rows;
  const double middle = median(record.temperature);
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const double value = record.temperature[row];
    if (value < scale->absolute_zero || std::abs(value - middle) > kFarTemperature * scale->per_kelvin)
      rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::vector<std::size_t> rows_of_unlike_magnitude(const Dataset& record) {
  if (record.rows() < kLeastMagnitudes || record.axes().size() < 2 || !record.has(Axis::input)) return {};
  const auto common = common_magnitude(record);
  if (!common) return {};
  std::vector<std::size_t> unlike;
  std::vector<std::size_t> alike;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const double off = std::abs(magnitude(record.at(row)) - common->value);
    (off > common->unlike ? unlike : alike).push_back(row);
  }
  if (unlike.empty() || static_cast<double>(alike.size()) < kMostRows * static_cast<double>(record.rows()))
    return {};
  unlike = of_no_level(record, unlike, common->unlike);
  leave_out_levels(record, *common, fit_linear(record.select(alike)), unlike);
  return unlike;
}

Finding unlike_magnitude(const Dataset& record, const std::vector<std::size_t>& rows) {
  const double to_declared = 1.0 / record.acceleration_unit.to_canonical;
  std::vector<double> sizes;
  for (const std::size_t row : thinned_rows(record.rows(), kSampledRows))
    sizes.push_back(magnitude(record.at(row)));
  return {.code = Code::magnitude_unlike_others,
          .severity = Severity::warning,
          .lines = record.lines_of(rows),
          .figures = {{"count", rows.size()},
                      {"line", record.line_of(rows.front())},
                      {"value", magnitude(record.at(rows.front())) * to_declared},
                      {"others", median(std::move(sizes)) * to_declared},
                      {"unit", record.acceleration_unit.symbol}}};
}

std::vector<Finding> find_implausible_inputs(const Dataset& record) {
  std::vector<Finding> findings;
  double largest = 0.0;
  for (const Axis axis : record.axes()) {
    for (const double a : record.along(axis)) largest = std::max(largest, std::abs(a));
  }
  if (largest > kLargestAcceleration) {
    findings.push_back({.code = Code::inputs_too_large,
                        .severity = Severity::warning,
                        .figures = {{"largest", largest},
                                    {"limit", kLargestAcceleration},
                                    {"read", record.acceleration_unit.symbol}}});
  }
  const std::vector<std::size_t> far = rows_of_no_temperature(record);
  if (!far.empty()) {
    findings.push_back({.code = Code::temperature_implausible,
                        .severity = Severity::warning,
                        .lines = record.lines_of(far),
                        .figures = {{"count", far.size()},
                                    {"line", record.line_of(far.front())},
                                    {"value", record.temperature[far.front()]},
                                    {"middle", median(record.temperature)},
                                    {"unit", record.temperature_unit.symbol}}});
  }
  return findings;
}

}  // namespace proofmass
