// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/misread_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "proofmass/assess/diagnosis/record/linear_fit.hpp"
#include "proofmass/assess/diagnosis/record/output_resolution.hpp"
#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"
#include "proofmass/assess/diagnosis/record/unexplained.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kLeastSampled = 12;      // rows, that leave eight degrees of freedom beside four terms
constexpr double kExplains = 0.1;              // of the outputs' variance, that another reading may leave
constexpr double kExplainsWithSign = 0.01;     // likewise, of rectified outputs: their squares leave 0.04
constexpr double kMuchCloserOtherwise = 25.0;  // in what is left of the outputs' variance
constexpr double kCloserAsAngle = 100.0;       // a sine bends as an output does that saturates
constexpr double kExplainedAlready = 1e-4;     // of the outputs' variance, that is left
constexpr double kLeastAngle = 90.0;           // degrees, of an axis' range
constexpr double kOneMagnitude = 0.02;         // of |A|
constexpr double kNearlyAll = 0.9;             // of the rows
constexpr std::size_t kMostShift = 10;         // rows
constexpr double kSameOutput = 1e-12;          // of each output
constexpr double kFineStep = 1e-5;             // of the range of the outputs

struct AngleUnit {
  const char* symbol;
  double degrees;
};
constexpr std::array kAngleUnits{AngleUnit{"deg", 1.0}, AngleUnit{"rad", 180.0 / std::numbers::pi}};
struct AngleFunction {
  const char* name;
  double (*of)(double radians);
};
constexpr std::array kAngleFunctions{AngleFunction{"cosine", [](double x) { return std::cos(x); }},
                                     AngleFunction{"sine", [](double x) { return std::sin(x); }}};

// As the record has the numbers, whatever their units; where they are written finely enough for an
// instrument's own bias and scale factor to show.
std::optional<Finding> find_copy(const Dataset& record) {
  const OutputResolution resolution = output_resolution(record);
  if (resolution.step > kFineStep * resolution.range) return std::nullopt;
  for (const Axis axis : record.axes()) {
    const bool same = std::equal(record.output.begin(), record.output.end(), record.along(axis).begin(),
                                 [&](double e, double a) {
                                   const double output = e / record.output_unit.to_canonical;
                                   return std::abs(output - a / record.acceleration_unit.to_canonical) <=
                                          kSameOutput * std::abs(output);
                                 });
    if (same) {
      return Finding{.code = Code::output_copies_input,
                     .severity = Severity::warning,
                     .figures = {{"axis", std::string(axis_name(axis))}}};
    }
  }
  return std::nullopt;
}

// What the outputs leave when the inputs are angles, of which each axis with enough of a range has this
// function.
double left_by_angles(const Dataset& rows, const AngleUnit& unit, const AngleFunction& function) {
  Dataset turned = rows;
  turned.acceleration_resolution = {};
  turned.acceleration_sigma = {};
  bool any = false;
  for (const Axis axis : rows.axes()) {
    std::vector<double>& values = turned.acceleration[static_cast<std::size_t>(axis)];
    const double to_degrees = unit.degrees / rows.acceleration_unit.to_canonical;
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    if ((*greatest - *least) * to_degrees < kLeastAngle) continue;
    any = true;
    for (double& value : values) value = function.of(value * to_degrees * std::numbers::pi / 180.0);
  }
  return any ? unexplained_by_linear_terms(turned) : 1.0;
}

// Whether two axes or three make one |A| in nearly all rows, as in a tumble: angles do not.
bool has_one_magnitude(const Dataset& rows) {
  if (rows.axes().size() < 2) return false;
  std::vector<double> sizes;
  for (std::size_t row = 0; row < rows.rows(); ++row) sizes.push_back(magnitude(rows.at(row)));
  std::vector<double> ordered(sizes);
  const auto middle = ordered.begin() + static_cast<std::ptrdiff_t>(ordered.size() / 2);
  std::nth_element(ordered.begin(), middle, ordered.end());
  const double near = kOneMagnitude * *middle;
  const auto alike = std::count_if(sizes.begin(), sizes.end(),
                                   [&](double size) { return std::abs(size - *middle) <= near; });
  return static_cast<double>(alike) >= kNearlyAll * static_cast<double>(sizes.size());
}

// Not of a record whose own inputs explain its outputs: a few values are as well on a sine as on a line.
std::optional<Finding> find_angles(const Dataset& rows, double unexplained) {
  if (unexplained < kExplainedAlready) return std::nullopt;
  for (const AngleUnit& unit : kAngleUnits) {
    for (const AngleFunction& function : kAngleFunctions) {
      const double left = left_by_angles(rows, unit, function);
      if (left > kExplains || left * kCloserAsAngle > unexplained) continue;
      return Finding{
          .code = Code::inputs_are_angles,
          .severity = Severity::warning,
          .figures = {{"written", std::string(unit.symbol)}, {"function", std::string(function.name)}}};
    }
  }
  return std::nullopt;
}

// What outputs leave that stand `shift` rows below their inputs (above where it is negative), and what is
// left of these outputs, and of those of these inputs, as they stand: the less of the two, and without their
// farthest rows. Rows that are far off could make a shift of a tumble, which looks the same when it is
// turned.
struct Shifted {
  double left = 1.0;
  double unshifted = 1.0;
};

Shifted with_shift(const Dataset& record, const std::vector<std::size_t>& sample, std::ptrdiff_t shift) {
  std::vector<std::size_t> inputs;
  std::vector<std::size_t> outputs;
  for (const std::size_t row : sample) {
    const auto of_inputs = static_cast<std::ptrdiff_t>(row) - shift;
    if (of_inputs < 0 || of_inputs >= static_cast<std::ptrdiff_t>(record.rows())) continue;
    outputs.push_back(row);
    inputs.push_back(static_cast<std::size_t>(of_inputs));
  }
  if (outputs.size() < kLeastSampled) return {};
  const Dataset own = record.select(outputs);
  const Dataset others = record.select(inputs);
  Dataset moved = others;
  moved.output = own.output;
  const double left = unexplained_by_linear_terms(moved);
  if (left >= kExplains) return {};
  const LinearFit fit = fit_linear(moved);
  if (std::abs(fit.scale_factor) <= fit.cross_axes) return {};  // a tumble that is turned
  return {.left = left,
          .unshifted = std::min(unexplained_without_far_rows(others), unexplained_without_far_rows(own))};
}

// Not of a record whose own inputs explain its outputs.
std::optional<Finding> find_shift(const Dataset& record, const std::vector<std::size_t>& sample,
                                  double unexplained) {
  if (unexplained * kMuchCloserOtherwise < kExplains) return std::nullopt;
  std::ptrdiff_t found = 0;
  double least = kExplains;
  const auto most = static_cast<std::ptrdiff_t>(std::min(kMostShift, record.rows() / 3));
  for (std::ptrdiff_t shift = -most; shift <= most; ++shift) {
    if (shift == 0) continue;
    const Shifted shifted = with_shift(record, sample, shift);
    if (shifted.left >= least || shifted.left * kMuchCloserOtherwise > shifted.unshifted) continue;
    least = shifted.left;
    found = shift;
  }
  if (found == 0) return std::nullopt;
  return Finding{.code = Code::rows_shifted,
                 .severity = Severity::warning,
                 .figures = {{"shift", std::abs(static_cast<double>(found))},
                             {"direction", std::string(found > 0 ? "below" : "above")}}};
}

std::optional<Finding> find_lost_sign(const Dataset& rows, double unexplained) {
  const auto [least, greatest] = std::minmax_element(rows.output.begin(), rows.output.end());
  if (*least < 0.0 && *greatest > 0.0) return std::nullopt;
  Dataset with_sign = rows;
  const std::vector<double>& a = rows.along(Axis::input);
  for (std::size_t row = 0; row < a.size(); ++row)
    with_sign.output[row] = std::copysign(rows.output[row], a[row]);
  const double left = unexplained_by_linear_terms(with_sign);
  if (left > kExplainsWithSign || left * kMuchCloserOtherwise > unexplained) return std::nullopt;
  return Finding{.code = Code::output_unsigned, .severity = Severity::warning};
}

}  // namespace

std::optional<Finding> find_misread_column(const Dataset& record) {
  if (record.rows() < kLeastSampled || !record.has(Axis::input)) return std::nullopt;
  if (auto copy = find_copy(record)) return copy;
  const std::vector<std::size_t> sample = thinned_rows(record.rows(), kSampledRows);
  const Dataset rows = record.select(sample);
  const double unexplained = unexplained_by_linear_terms(rows);
  if (!has_one_magnitude(rows)) {
    if (auto angles = find_angles(rows, unexplained)) return angles;
  }
  if (auto shift = find_shift(record, sample, unexplained)) return shift;
  return find_lost_sign(rows, unexplained);
}

}  // namespace proofmass
