// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/likely_reason.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "proofmass/assess/diagnosis/record/term_space.hpp"
#include "proofmass/assess/diagnosis/record/unexplained.hpp"

namespace proofmass {
namespace {

constexpr double kMostlyAlong = 0.7;  // of |A| along the input axis
constexpr std::size_t kLeastRatios = 8;
constexpr double kNearRatio = 0.1;
constexpr double kSome = 0.04;  // of the rows
constexpr double kMostOfThem = 0.9;

// Output over Ai, of the rows that have enough of it.
std::vector<double> ratios_of(const Dataset& record) {
  std::vector<double> ratios;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const Acceleration a = record.at(row);
    if (std::abs(a.i) > kMostlyAlong * magnitude(a)) ratios.push_back(std::abs(record.output[row] / a.i));
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

std::string likely_reason(const FittedRows& rows, double unexplained) {
  const Dataset& record = rows.record();
  if (units_are_mixed(record)) return "mixed";
  if (unexplained_by(orthonormal_rows(record, full_terms()), record.output) < unexplained) return "terms";
  if (unexplained_without_far_rows(record) < unexplained) return "rows";
  return {};
}

}  // namespace proofmass
