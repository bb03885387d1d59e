// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/wrapped_counts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "proofmass/assess/diagnosis/record/linear_fit.hpp"
#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"

namespace proofmass {
namespace {

constexpr int kFewestBits = 8;
constexpr int kMostBits = 24;
constexpr double kCloser = 9.0;      // in the sum of squares
constexpr double kLargeCross = 0.5;  // of the scale factor
constexpr double kSmallCross = 0.1;
constexpr std::size_t kLeastRows = 6;

// Whole numbers, or what is said to be counts: their means are none.
bool are_counts(const Dataset& record) {
  return record.output_unit.quantity == Quantity::count ||
         std::all_of(record.output.begin(), record.output.end(),
                     [](double v) { return v == std::nearbyint(v); });
}

// Where the outputs are farthest apart: the largest output below the gap, and the width of the gap.
struct Gap {
  double below = 0.0;
  double width = 0.0;
};

Gap widest_gap(std::vector<double> outputs) {
  std::sort(outputs.begin(), outputs.end());
  Gap gap;
  for (std::size_t k = 1; k < outputs.size(); ++k) {
    const double width = outputs[k] - outputs[k - 1];
    if (width > gap.width) gap = {.below = outputs[k - 1], .width = width};
  }
  return gap;
}

// Whether the outputs follow the inputs more closely than before, or, where few set-ups let bias and cross
// axes take up the jump, as closely and by a scale factor that is then larger than they are.
bool is_plainer(const LinearFit& unwrapped, const LinearFit& before) {
  if (before.rss > kCloser * unwrapped.rss) return true;
  const auto crosses = [](const LinearFit& fit) { return fit.cross_axes / std::abs(fit.scale_factor); };
  return kCloser * before.rss > unwrapped.rss && crosses(before) > kLargeCross &&
         crosses(unwrapped) < kSmallCross;
}

}  // namespace

std::optional<Finding> find_wrapped_counts(const Dataset& record) {
  if (record.rows() < kLeastRows || !are_counts(record)) return std::nullopt;
  Dataset rows = record.select(thinned_rows(record.rows()));
  const auto [least, greatest] = std::minmax_element(record.output.begin(), record.output.end());
  const double range = *greatest - *least;
  const Gap gap = widest_gap(rows.output);
  for (int bits = kFewestBits; bits <= kMostBits; ++bits) {
    const double turn = std::ldexp(1.0, bits);
    // The groups must lie within one turn, and be nearer to each other across its ends than across the gap.
    if (range >= turn || gap.width <= turn - range) continue;
    const LinearFit before = fit_linear(rows);
    std::size_t upper = 0;
    for (double& e : rows.output) {
      if (e <= gap.below) continue;
      e -= turn;
      ++upper;
    }
    if (!is_plainer(fit_linear(rows), before)) return std::nullopt;
    return Finding{
        .code = Code::output_wrapped,
        .severity = Severity::warning,
        .figures = {{"bits", static_cast<double>(bits)},
                    {"turn", turn},
                    {"below", gap.below},
                    {"above", gap.below + gap.width},
                    {"percent", 100.0 * static_cast<double>(upper) / static_cast<double>(rows.rows())}}};
  }
  return std::nullopt;
}

}  // namespace proofmass
