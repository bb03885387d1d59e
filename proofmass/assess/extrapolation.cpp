// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/extrapolation.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace proofmass {
namespace {

// Earlier results know the range of a network alone.
std::vector<std::pair<Axis, Interval>> known_range(const Identification& result) {
  if (!result.input_range.empty() || !result.network) return result.input_range;
  std::vector<std::pair<Axis, Interval>> ranges;
  for (std::size_t k = 0; k < result.network->inputs.size(); ++k) {
    ranges.emplace_back(result.network->inputs[k], result.network->input_range[k]);
  }
  return ranges;
}

// A network takes all its inputs, a static model those of its terms.
bool uses(const Identification& result, Axis axis) {
  if (result.network) return true;
  return std::any_of(result.coefficients.begin(), result.coefficients.end(),
                     [axis](const Coefficient& c) { return c.identified && info(c.term).uses(axis); });
}

}  // namespace

std::optional<Finding> find_extrapolation(const Identification& result, const Dataset& inputs) {
  const auto ranges = known_range(result);
  const auto outside = [&](std::size_t row) {
    return std::any_of(ranges.begin(), ranges.end(), [&](const auto& axis_range) {
      const auto& [axis, range] = axis_range;
      if (!inputs.has(axis) || !uses(result, axis)) return false;
      const double a = inputs.along(axis)[row];
      return a < range.low || a > range.high;
    });
  };
  std::size_t count = 0;
  std::size_t first = 0;
  for (std::size_t row = 0; row < inputs.rows(); ++row) {
    if (!outside(row)) continue;
    if (count++ == 0) first = inputs.line_of(row);
  }
  if (count == 0) return std::nullopt;
  return Finding{.code = Code::inputs_outside_range,
                 .severity = Severity::warning,
                 .lines = {first},
                 .figures = {{"count", count}, {"total", inputs.rows()}, {"line", first}}};
}

}  // namespace proofmass
