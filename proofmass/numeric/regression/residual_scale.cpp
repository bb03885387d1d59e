// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/regression/residual_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "proofmass/numeric/regression/robust_loss.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kLeastDistinct = 5;
constexpr double kOffGrid = 0.02;  // of a step
constexpr double kRoundingOfGrid = 64.0 * std::numeric_limits<double>::epsilon();
constexpr std::size_t kLeastSpareRows = 15;
constexpr int kSpread = 8;  // points that stand for an even spread
// Of |r| over sigma for normal residuals: the median, and the 60 % quantile.
constexpr double kNormalMedian = 0.6744897501960817;
constexpr double kNormalSixty = 0.8416212335729143;
// Above the largest ratios in 300 records each of normal, t(3) and 10 % outlier residuals, of 25 to 1000
// rows; with 15 to 29 rows more than 2 to 15 parameters, 0.3 % of 1000 records of normal and t(3) residuals
// exceed them.
constexpr double kMostOverShortest = 1.15;
constexpr double kMostOverShortestTimesRows = 45.0;
constexpr double kMostQuantileRatio = 1.5;
constexpr double kMostQuantileRatioTimesRows = 20.0;

double shortest_half(std::vector<double> residuals, std::size_t fitted) {
  std::sort(residuals.begin(), residuals.end());
  const std::size_t span = std::min((residuals.size() + fitted) / 2, residuals.size() - 1);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r + span < residuals.size(); ++r) {
    shortest = std::min(shortest, residuals[r + span] - residuals[r]);
  }
  return 0.5 * shortest / kNormalMedian;
}

// Of the sizes, less the `fitted` smallest, which a fit can bring to zero.
double sixty_percent_scale(std::vector<double> residuals, std::size_t fitted) {
  for (double& r : residuals) r = std::abs(r);
  const std::size_t left = residuals.size() - fitted;
  const std::size_t place = fitted + left * 6 / 10;
  std::nth_element(residuals.begin(), residuals.begin() + static_cast<std::ptrdiff_t>(place),
                   residuals.end());
  return residuals[place] / kNormalSixty;
}

}  // namespace

double grid_step(std::span<const double> values) {
  std::vector<double> distinct(values.begin(), values.end());
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.size() < kLeastDistinct) return 0.0;
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < distinct.size(); ++k) step = std::min(step, distinct[k] - distinct[k - 1]);
  const double largest = std::max(std::abs(distinct.front()), std::abs(distinct.back()));
  if (!(step > kRoundingOfGrid * largest)) return 0.0;
  for (const double value : distinct) {
    const double steps = (value - distinct.front()) / step;
    const double whole = std::round(steps);
    if (std::abs(steps - whole) > kOffGrid) return 0.0;
    if (whole > 0.0) step = (value - distinct.front()) / whole;  // the farther, the more exact
  }
  return step;
}

double grouped_median_scale(std::span<const double> residuals, std::size_t fitted, double step) {
  std::vector<double> spread;
  spread.reserve(kSpread * residuals.size());
  for (const double residual : residuals) {
    for (int k = 0; k < kSpread; ++k) spread.push_back(residual + step * ((k + 0.5) / kSpread - 0.5));
  }
  return median_scale(spread, kSpread * fitted);
}

ScaleCheck check_scale(std::span<const double> residuals, std::size_t fitted, double scale,
                       double resolution) {
  ScaleCheck check;
  if (residuals.size() < fitted + kLeastSpareRows || !(scale > 0.0)) return check;
  const std::vector<double> rows(residuals.begin(), residuals.end());
  const double shortest = std::max(shortest_half(rows, fitted), scale * std::numeric_limits<double>::min());
  check.over_shortest_half = scale / (shortest + resolution);
  check.quantile_ratio = std::max(0.0, sixty_percent_scale(rows, fitted) - resolution) / scale;
  const auto n = static_cast<double>(residuals.size() - fitted);
  check.doubtful = check.over_shortest_half > kMostOverShortest + kMostOverShortestTimesRows / n ||
                   check.quantile_ratio > kMostQuantileRatio + kMostQuantileRatioTimesRows / n;
  return check;
}

}  // namespace proofmass
