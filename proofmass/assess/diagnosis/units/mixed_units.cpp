// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/units/mixed_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"
#include "proofmass/assess/diagnosis/record/unexplained.hpp"
#include "proofmass/core/units.hpp"

namespace proofmass {
namespace {

constexpr double kMostlyAlong = 0.7;  // of |A| along the input axis
constexpr std::size_t kLeastRatios = 8;
constexpr double kNearRatio = 0.1;
constexpr double kSome = 0.04;  // of the rows
constexpr double kMostOfThem = 0.9;
constexpr double kCloserInOneUnit = 25.0;  // in what is left of the outputs' variance
constexpr std::array kUnitRatios{kStandardGravity, 1e3};

// Rows with enough of the input axis, and output over Ai in each.
struct AlongInput {
  std::vector<std::size_t> rows;
  std::vector<double> ratios;
};

AlongInput along_input(const Dataset& record, const std::vector<std::size_t>& rows) {
  AlongInput along;
  for (const std::size_t row : rows) {
    const Acceleration a = record.at(row);
    if (!(std::abs(a.i) > kMostlyAlong * magnitude(a))) continue;
    along.rows.push_back(row);
    along.ratios.push_back(std::abs(record.output[row] / a.i));
  }
  return along;
}

std::vector<std::size_t> rows_near(const AlongInput& along, double ratio) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < along.rows.size(); ++k) {
    if (std::abs(along.ratios[k] / ratio - 1.0) < kNearRatio) rows.push_back(along.rows[k]);
  }
  return rows;
}

// Whether the rows along the input axis follow it when those of the larger ratio are taken to one unit with
// the others.
bool agree_in_one_unit(const Dataset& record, const AlongInput& along, const std::vector<std::size_t>& upper,
                       double unit) {
  Dataset rows = record.select(along.rows);
  const double before = unexplained_by_linear_terms(rows);
  for (std::size_t k = 0; k < along.rows.size(); ++k) {
    if (!std::binary_search(upper.begin(), upper.end(), along.rows[k])) continue;
    rows.output[k] /= unit;
  }
  const double after = unexplained_by_linear_terms(rows);
  // Where it was the inputs that are in another unit, they are to be multiplied with the outputs.
  for (std::size_t k = 0; k < along.rows.size(); ++k) {
    if (std::binary_search(upper.begin(), upper.end(), along.rows[k])) {
      rows.output[k] *= unit;
      continue;
    }
    for (std::vector<double>& axis : rows.acceleration) {
      if (!axis.empty()) axis[k] /= unit;
    }
  }
  return std::min(after, unexplained_by_linear_terms(rows)) * kCloserInOneUnit < before;
}

std::vector<std::size_t> of_other_unit(const Dataset& record, const std::vector<std::size_t>& sample) {
  const AlongInput along = along_input(record, sample);
  if (along.rows.size() < kLeastRatios) return {};
  std::vector<double> ordered(along.ratios);
  const auto at = ordered.begin() + static_cast<std::ptrdiff_t>(ordered.size() * 19 / 20);
  std::nth_element(ordered.begin(), at, ordered.end());
  const auto all = static_cast<double>(along.rows.size());
  for (const double unit : kUnitRatios) {
    const std::vector<std::size_t> upper = rows_near(along, *at);
    const std::vector<std::size_t> lower = rows_near(along, *at / unit);
    const auto some = static_cast<double>(upper.size());
    const auto others = static_cast<double>(lower.size());
    if (!(some > kSome * all && others > kSome * all && some + others > kMostOfThem * all)) continue;
    if (agree_in_one_unit(record, along, upper, unit)) return some < others ? upper : lower;
  }
  return {};
}

}  // namespace

std::vector<std::size_t> rows_in_other_unit(const Dataset& record) {
  if (!record.has(Axis::input)) return {};
  return of_other_unit(record, thinned_rows(record.rows()));
}

}  // namespace proofmass
