// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/implausible_inputs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <tuple>
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
constexpr double kTightMagnitude = 0.1;   // of |A|: rows within more have not one, but many
constexpr double kUnlikeMagnitude = 5.0;  // times as far from it
constexpr double kLeastUnlike = 1e-5;     // of |A|
constexpr double kOtherLevel = 2.0;  // |A| over the others': the row may be at another level of acceleration
constexpr double kAgreesWithOutput = 0.1;  // of the difference in |A|, by which the output may miss
constexpr double kManyTimes = 20.0;        // what nine tenths of the rows have, of an input that is none
constexpr double kFewTimes = 2.0;          // likewise, of one that may be
constexpr std::size_t kFewMistyped = 2;    // that agree with their outputs, and may be mistyped across Ai

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
  if (same > kTightMagnitude * common.value) return std::nullopt;
  common.unlike = std::max(kUnlikeMagnitude * same, kLeastUnlike * common.value);
  return common;
}

// Rows with the same inputs: readings of one set-up.
struct SetUp {
  Acceleration inputs;
  double size = 0.0;
  std::vector<std::size_t> rows;
};

std::vector<SetUp> set_ups_of(const Dataset& record, const std::vector<std::size_t>& rows) {
  std::map<std::tuple<double, double, double, double>, std::vector<std::size_t>> by_inputs;
  for (const std::size_t row : rows) {
    const Acceleration a = record.at(row);
    by_inputs[{magnitude(a), a.i, a.o, a.p}].push_back(row);
  }
  std::vector<SetUp> set_ups;
  for (auto& [key, members] : by_inputs) {
    const Acceleration a = record.at(members.front());
    set_ups.push_back({.inputs = a, .size = magnitude(a), .rows = std::move(members)});
  }
  return set_ups;
}

// Without those, ascending by |A|, that have one |A| together: they are at another level of acceleration.
std::vector<SetUp> of_no_level(const std::vector<SetUp>& set_ups, double tolerance) {
  std::vector<SetUp> alone;
  for (std::size_t k = 0; k < set_ups.size(); ++k) {
    const bool below = k > 0 && set_ups[k].size - set_ups[k - 1].size < tolerance;
    const bool above = k + 1 < set_ups.size() && set_ups[k + 1].size - set_ups[k].size < tolerance;
    if (!below && !above) alone.push_back(set_ups[k]);
  }
  return alone;
}

// Whether the output follows the acceleration of a set-up as the fit to the others has it, as far as their
// noise lets it tell.
bool agrees_with_output(const Dataset& record, const CommonMagnitude& common, const LinearFit& others,
                        const SetUp& set_up) {
  const double difference = std::abs(others.scale_factor) * std::abs(set_up.size - common.value);
  const double missed = std::abs(record.output[set_up.rows.front()] - others.model.output(set_up.inputs));
  return missed < std::max(kAgreesWithOutput * difference, kMagnitudeScales * others.scale);
}

// Without set-ups whose output follows their acceleration: they may be at another level. One or two of nearly
// the others' |A| may be mistyped across the input axis, which the output does not show.
void leave_out_levels(const Dataset& record, const CommonMagnitude& common, const LinearFit& others,
                      std::vector<SetUp>& set_ups) {
  const auto agrees = [&](const SetUp& one) { return agrees_with_output(record, common, others, one); };
  const auto is_other_level = [&](const SetUp& one) {
    return agrees(one) && (std::abs(one.inputs.i) > common.value + common.unlike ||
                           one.size > kOtherLevel * common.value || one.size * kOtherLevel < common.value);
  };
  const auto agreeing = static_cast<std::size_t>(std::count_if(set_ups.begin(), set_ups.end(), agrees));
  if (agreeing <= kFewMistyped && std::none_of(set_ups.begin(), set_ups.end(), is_other_level)) return;
  std::erase_if(set_ups, agrees);
}

// Rows in which an axis is many times as large as in nearly all: few, and with nothing between.
std::vector<std::size_t> rows_far_along(const Dataset& record, Axis axis) {
  std::vector<double> sizes;
  for (const double a : record.along(axis)) sizes.push_back(std::abs(a));
  std::vector<double> ordered(sizes);
  const auto limit =
      ordered.begin() + static_cast<std::ptrdiff_t>(kMostRows * static_cast<double>(sizes.size()));
  std::nth_element(ordered.begin(), limit, ordered.end());
  const double usual = *limit;
  std::vector<std::size_t> far;
  for (std::size_t row = 0; row < sizes.size(); ++row) {
    if (sizes[row] <= kManyTimes * usual) {
      if (sizes[row] > kFewTimes * usual) return {};
      continue;
    }
    far.push_back(row);
  }
  return usual > 0.0 ? far : std::vector<std::size_t>();
}

struct TemperatureScale {
  const char* symbol;
  double absolute_zero;
  double per_kelvin;
};
constexpr std::array kTemperatureScales{TemperatureScale{"degC", -273.15, 1.0},
                                        TemperatureScale{"K", 0.0, 1.0},
                                        TemperatureScale{"degF", -459.67, 1.8}};

// Below absolute zero; or few, and far from the temperature of most rows with nothing between.
std::vector<std::size_t> rows_of_no_temperature(const Dataset& record, const TemperatureScale& scale) {
  const double middle = median(record.temperature);
  const double far = kFarTemperature * scale.per_kelvin;
  double nearest = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> rows;
  std::vector<std::size_t> impossible;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const double off = std::abs(record.temperature[row] - middle);
    if (record.temperature[row] < scale.absolute_zero) impossible.push_back(row);
    if (off <= far) continue;
    rows.push_back(row);
    nearest = std::min(nearest, off);
  }
  const bool between = std::any_of(record.temperature.begin(), record.temperature.end(), [&](double value) {
    const double off = std::abs(value - middle);
    return off <= far && off > nearest - far;
  });
  const bool few = static_cast<double>(rows.size()) <= (1.0 - kMostRows) * static_cast<double>(record.rows());
  return few && !between && !rows.empty() ? rows : impossible;
}

}  // namespace

UnlikeRows rows_of_unlike_magnitude(const Dataset& record) {
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
  std::vector<SetUp> set_ups = of_no_level(set_ups_of(record, unlike), common->unlike);
  leave_out_levels(record, *common, fit_linear(record.select(alike)), set_ups);
  UnlikeRows found{.others = common->value};
  for (const SetUp& set_up : set_ups)
    found.rows.insert(found.rows.end(), set_up.rows.begin(), set_up.rows.end());
  std::sort(found.rows.begin(), found.rows.end());
  return found;
}

Finding unlike_magnitude(const Dataset& record, const UnlikeRows& unlike) {
  const double to_declared = 1.0 / record.acceleration_unit.to_canonical;
  const std::size_t first = unlike.rows.front();
  return {.code = Code::magnitude_unlike_others,
          .severity = Severity::warning,
          .lines = record.lines_of(unlike.rows),
          .figures = {{"count", unlike.rows.size()},
                      {"line", record.line_of(first)},
                      {"value", magnitude(record.at(first)) * to_declared},
                      {"others", unlike.others * to_declared},
                      {"unit", record.acceleration_unit.symbol}}};
}

std::optional<Finding> find_too_large_inputs(const Dataset& record) {
  double largest = 0.0;
  for (const Axis axis : record.axes()) {
    for (const double a : record.along(axis)) largest = std::max(largest, std::abs(a));
  }
  if (largest <= kLargestAcceleration) return std::nullopt;
  return Finding{
      .code = Code::inputs_too_large,
      .severity = Severity::warning,
      .figures = {
          {"largest", largest}, {"limit", kLargestAcceleration}, {"read", record.acceleration_unit.symbol}}};
}

std::optional<Finding> find_far_input(const Dataset& record) {
  if (record.rows() < kLeastMagnitudes) return std::nullopt;
  for (const Axis axis : record.axes()) {
    const std::vector<std::size_t> far = rows_far_along(record, axis);
    if (far.empty()) continue;
    return Finding{
        .code = Code::input_far_off,
        .severity = Severity::warning,
        .lines = record.lines_of(far),
        .figures = {{"axis", std::string(axis_name(axis))},
                    {"count", far.size()},
                    {"line", record.line_of(far.front())},
                    {"value", record.along(axis)[far.front()] / record.acceleration_unit.to_canonical},
                    {"unit", record.acceleration_unit.symbol},
                    {"limit", kManyTimes}}};
  }
  return std::nullopt;
}

std::optional<Finding> find_implausible_temperature(const Dataset& record) {
  const auto scale = std::find_if(kTemperatureScales.begin(), kTemperatureScales.end(), [&](const auto& one) {
    return one.symbol == record.temperature_unit.symbol;
  });
  if (record.temperature.empty() || scale == kTemperatureScales.end()) return std::nullopt;
  const std::vector<std::size_t> far = rows_of_no_temperature(record, *scale);
  if (far.empty()) return std::nullopt;
  return Finding{.code = Code::temperature_implausible,
                 .severity = Severity::warning,
                 .lines = record.lines_of(far),
                 .figures = {{"count", far.size()},
                             {"line", record.line_of(far.front())},
                             {"value", record.temperature[far.front()]},
                             {"limit", kFarTemperature * scale->per_kelvin},
                             {"unit", record.temperature_unit.symbol}}};
}

}  // namespace proofmass
