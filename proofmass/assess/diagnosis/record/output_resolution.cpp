// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/output_resolution.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"
#include "proofmass/numeric/regression/residual_scale.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kRowsForStep = 4096;

// The decimal step in which all the values are written, ten decimals at most; zero when they have more.
double decimal_step(const std::vector<double>& values) {
  double scale = 1.0;
  for (int decimals = 0; decimals <= 10; ++decimals, scale *= 10.0) {
    const bool all = std::all_of(values.begin(), values.end(), [scale](double v) {
      const double x = v * scale;
      return std::abs(x - std::nearbyint(x)) <= 1e-5 + 1e-13 * std::abs(x);
    });
    if (all) return 1.0 / scale;
  }
  return 0.0;
}

}  // namespace

OutputResolution output_resolution(const Dataset& record) {
  std::vector<double> values;
  for (const std::size_t row : thinned_rows(record.rows(), kRowsForStep))
    values.push_back(record.output[row] / record.output_unit.to_canonical);
  const auto [least, greatest] = std::minmax_element(record.output.begin(), record.output.end());
  const double factor = std::abs(record.output_unit.to_canonical);
  const double decimals = decimal_step(values);
  return {.step = factor * std::max(decimals, grid_step(values)),
          .decimals = factor * decimals,
          .range = *greatest - *least};
}

}  // namespace proofmass
