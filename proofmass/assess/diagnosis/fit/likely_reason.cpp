// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/likely_reason.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "proofmass/assess/diagnosis/record/term_space.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kMostShift = 3;
constexpr double kShifted = 0.5;      // of what a reason may leave: neighbouring rows can be alike
constexpr double kMostlyAlong = 0.7;  // of |A| along the input axis
constexpr std::size_t kLeastRatios = 8;
constexpr double kNearRatio = 0.1;
constexpr double kSome = 0.04;  // of the rows
constexpr double kMostOfThem = 0.9;
constexpr double kLeastAngles = 45.0;  // degrees: less of a range shows no cosine

double total(std::span<const double> values) {
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return std::accumulate(values.begin(), values.end(), 0.0,
                         [mean](double sum, double v) { return sum + (v - mean) * (v - mean); });
}

// The fraction of the outputs' variance that least squares on the columns of the basis leaves, with allowance
// for the number of columns.
double unexplained_by(const Matrix& basis, std::span<const double> output) {
  const auto n = static_cast<double>(output.size());
  const auto dof = n - static_cast<double>(basis.columns());
  if (dof < 1.0) return 1.0;
  const double rss = sum_of_squares(beyond_columns(basis, {output.begin(), output.end()}));
  return rss / dof * (n - 1.0) / total(output);
}

// What a fit leaves without the tenth of the rows that are farthest off.
double without_far_rows(const FittedRows& rows) {
  std::vector<double> sizes;
  for (const double r : rows.residuals()) sizes.push_back(std::abs(r));
  const auto limit = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
  std::nth_element(sizes.begin(), limit, sizes.end());
  std::vector<std::size_t> near;
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    if (std::abs(rows.residuals()[row]) < *limit) near.push_back(row);
  }
  const Dataset others = rows.record().select(near);
  return unexplained_by(orthonormal_rows(others, linear_terms()), others.output);
}

// What outputs leave that stand beside the inputs of the row that is `shift` above (or below).
double with_shift(const Dataset& record, std::ptrdiff_t shift) {
  const auto n = static_cast<std::ptrdiff_t>(record.rows());
  if (n <= 3 * static_cast<std::ptrdiff_t>(kMostShift)) return 1.0;
  std::vector<std::size_t> inputs;
  std::vector<double> output;
  for (std::ptrdiff_t row = 0; row < n; ++row) {
    if (row - shift < 0 || row - shift >= n) continue;
    inputs.push_back(static_cast<std::size_t>(row - shift));
    output.push_back(record.output[static_cast<std::size_t>(row)]);
  }
  return unexplained_by(orthonormal_rows(record.select(inputs), linear_terms()), output);
}

// The shift in rows between outputs and inputs; zero where none is seen.
std::size_t shift_of(const Dataset& record, double unexplained) {
  for (std::size_t shift = 1; shift <= kMostShift; ++shift) {
    const auto rows = static_cast<std::ptrdiff_t>(shift);
    if (with_shift(record, rows) < unexplained || with_shift(record, -rows) < unexplained) return shift;
  }
  return 0;
}

// What the outputs leave when the inputs are angles in degrees, of which each axis has this function.
double as_angles(const Dataset& record, double (*function)(double)) {
  Dataset turned = record;
  bool any = false;
  for (const Axis axis : record.axes()) {
    std::vector<double>& values = turned.acceleration[static_cast<std::size_t>(axis)];
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    if ((*greatest - *least) / record.acceleration_unit.to_canonical < kLeastAngles) continue;
    any = true;
    for (double& value : values)
      value = function(value / record.acceleration_unit.to_canonical * std::numbers::pi / 180.0);
  }
  return any ? unexplained_by(orthonormal_rows(turned, linear_terms()), record.output) : 1.0;
}

// Output over Ai, of the rows that have enough of it.
std::vector<double> ratios_of(const Dataset& record) {
  std::vector<double> ratios;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const Acceleration a = record.at(row);
    const double size = std::sqrt(a.i * a.i + a.o * a.o + a.p * a.p);
    if (std::abs(a.i) > kMostlyAlong * size) ratios.push_back(std::abs(record.output[row] / a.i));
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

// Whether the outputs are in one ratio to the inputs in some rows, and in a unit's ratio to that in the
// others.
bool units_are_mixed(const Dataset& record) {
  if (!record.has(Axis::input)) return false;
  const std::vector<double> ratios = ratios_of(record);
  if (ratios.size() < kLeastRatios) return false;
  const auto near = [&ratios](double ratio) {
    return static_cast<double>(
               std::count_if(ratios.begin(), ratios.end(),
                             [ratio](double r) { return std::abs(r / ratio - 1.0) < kNearRatio; })) /
           static_cast<double>(ratios.size());
  };
  const double upper = ratios[ratios.size() * 19 / 20];
  for (const double unit : {kStandardGravity, 1e3}) {
    const double some = near(upper);
    const double others = near(upper / unit);
    if (some > kSome && others > kSome && some + others > kMostOfThem) return true;
  }
  return false;
}

}  // namespace

Reason likely_reason(const FittedRows& rows, double unexplained) {
  const Dataset& record = rows.record();
  const auto cosine = [](double x) { return std::cos(x); };
  const auto sine = [](double x) { return std::sin(x); };
  if (as_angles(record, cosine) < unexplained || as_angles(record, sine) < unexplained)
    return {.name = "angles"};
  if (units_are_mixed(record)) return {.name = "mixed"};
  if (unexplained_by(orthonormal_rows(record, full_terms()), record.output) < unexplained)
    return {.name = "terms"};
  const std::size_t shift = shift_of(record, kShifted * unexplained);
  if (shift == 0 && without_far_rows(rows) < unexplained) return {.name = "rows"};
  return {.name = shift != 0 ? "shifted" : "", .shift = shift};
}

}  // namespace proofmass
