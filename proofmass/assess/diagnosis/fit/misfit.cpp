// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/misfit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace proofmass {
namespace {

constexpr double kGross = 0.9;
constexpr double kUnrelated = 0.1;
constexpr std::size_t kMostShift = 3;
constexpr double kLeastAngles = 45.0;  // degrees: less of a range shows no cosine

double total(std::span<const double> values) {
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return std::accumulate(values.begin(), values.end(), 0.0,
                         [mean](double sum, double v) { return sum + (v - mean) * (v - mean); });
}

// Whether least squares on the columns of the basis explains most of the outputs' variance, with allowance
// for the number of columns.
bool explains(const Matrix& basis, std::span<const double> output) {
  const auto n = static_cast<double>(output.size());
  const auto dof = n - static_cast<double>(basis.columns());
  if (dof < 1.0) return false;
  const double rss = sum_of_squares(beyond_columns(basis, {output.begin(), output.end()}));
  return 1.0 - rss / dof * (n - 1.0) / total(output) > kGross;
}

// Whether the fit is good but for the tenth of the rows that are farthest off.
bool few_rows_are_off(const FittedRows& rows) {
  std::vector<double> sizes;
  for (const double r : rows.residuals()) sizes.push_back(std::abs(r));
  const auto limit = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
  std::nth_element(sizes.begin(), limit, sizes.end());
  std::vector<std::size_t> near;
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    if (std::abs(rows.residuals()[row]) < *limit) near.push_back(row);
  }
  const Dataset others = rows.record().select(near);
  return explains(orthonormal_rows(others, linear_terms()), others.output);
}

// Whether the outputs follow the inputs of the row that is `shift` above (or below).
bool follows_shifted(const Dataset& record, std::ptrdiff_t shift) {
  const auto n = static_cast<std::ptrdiff_t>(record.rows());
  if (n <= 3 * static_cast<std::ptrdiff_t>(kMostShift)) return false;
  std::vector<std::size_t> inputs;
  std::vector<double> output;
  for (std::ptrdiff_t row = 0; row < n; ++row) {
    if (row - shift < 0 || row - shift >= n) continue;
    inputs.push_back(static_cast<std::size_t>(row - shift));
    output.push_back(record.output[static_cast<std::size_t>(row)]);
  }
  return explains(orthonormal_rows(record.select(inputs), linear_terms()), output);
}

// The shift in rows between outputs and inputs; zero where none is seen.
std::ptrdiff_t shift_of(const Dataset& record) {
  for (std::ptrdiff_t shift = 1; shift <= static_cast<std::ptrdiff_t>(kMostShift); ++shift) {
    if (follows_shifted(record, shift)) return shift;
    if (follows_shifted(record, -shift)) return -shift;
  }
  return 0;
}

bool inputs_are_angles(const Dataset& record) {
  Dataset cosines = record;
  bool any = false;
  for (const Axis axis : record.axes()) {
    std::vector<double>& values = cosines.acceleration[static_cast<std::size_t>(axis)];
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    if (*greatest - *least < kLeastAngles) continue;
    any = true;
    for (double& value : values) {
      value = std::cos(value / record.acceleration_unit.to_canonical * std::numbers::pi / 180.0);
    }
  }
  return any && explains(orthonormal_rows(cosines, linear_terms()), record.output);
}

// A choice by name; `shift`, of the rows between outputs and inputs, where that is the reason.
std::string reason_of(const FittedRows& rows, double r2, std::ptrdiff_t& shift) {
  const Dataset& record = rows.record();
  if (inputs_are_angles(record)) return "angles";
  if (explains(orthonormal_rows(record, full_terms()), record.output)) return "terms";
  if (few_rows_are_off(rows)) return "rows";
  shift = shift_of(record);
  if (shift != 0) return "shifted";
  return r2 < kUnrelated ? "unrelated" : "unknown";
}

}  // namespace

std::optional<Finding> find_misfit(const FittedRows& rows, const Identification& result) {
  if (!result.train || !result.train->r2 || *result.train->r2 >= kGross) return std::nullopt;
  std::ptrdiff_t shift = 0;
  std::string reason = reason_of(rows, *result.train->r2, shift);
  return Finding{.code = Code::gross_misfit,
                 .severity = Severity::warning,
                 .figures = {{"r2", *result.train->r2},
                             {"limit", kGross},
                             {"reason", std::move(reason)},
                             {"shift", static_cast<double>(std::abs(shift))}}};
}

}  // namespace proofmass
