// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/growing_variance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "proofmass/numeric/compensated.hpp"
#include "proofmass/numeric/row_shares.hpp"

namespace proofmass {
namespace {

constexpr double kLargestShare = 1.0 - 1e-6;
constexpr double kEvenGrowth = 1e-9;  // relative spread below which growth counts as the same in every row
constexpr int kTrials = 100;          // of a share; a dozen find it to the last digits

// Relative variance 1 - share + share * growth / mean growth: its mean is 1.
class VarianceShape {
 public:
  explicit VarianceShape(std::span<const double> growth) : relative_(growth.begin(), growth.end()) {
    for (const double value : growth) mean_ += value / static_cast<double>(growth.size());
    for (double& value : relative_) {
      if (!(value >= 0.0)) throw std::invalid_argument("growth must not be negative");
      value = mean_ > 0.0 ? value / mean_ : 1.0;
    }
  }
  [[nodiscard]] bool varies() const {
    const auto [low, high] = std::minmax_element(relative_.begin(), relative_.end());
    return *high - *low > kEvenGrowth;
  }
  [[nodiscard]] double mean() const { return mean_; }
  [[nodiscard]] double at(std::size_t row, double share) const { return 1.0 + share * slope(row); }
  [[nodiscard]] double slope(std::size_t row) const { return relative_[row] - 1.0; }
  [[nodiscard]] std::vector<double> weights(double share) const {
    std::vector<double> result(relative_.size());
    for (std::size_t row = 0; row < result.size(); ++row) result[row] = 1.0 / at(row, share);
    return result;
  }

 private:
  std::vector<double> relative_;
  double mean_ = 0.0;
};

// Sums over rows that the score needs, u the relative variance: residual²/u, slope residual²/u² and
// slope (1 - leverage)/u.
struct ScoreSums {
  CompensatedSum squares, pull, expected;

  void add(double square, double leverage, double slope, double u) {
    const double inverse = 1.0 / u;
    const double weighted = square * inverse;
    squares.add(weighted);
    pull.add(slope * weighted * inverse);
    expected.add(slope * (1.0 - leverage) * inverse);
  }
};

// Derivative of the restricted log-likelihood by the share, the common factor of the variances at its
// maximum: sum of slope * (residual² / (factor u²) - (1 - leverage) / u).
double share_score(const VarianceShape& shape, const WeightedFit& fit, double dof, double share) {
  const std::size_t rows = fit.residuals.size();
  std::vector<ScoreSums> parts(row_shares(rows));
  for_each_row_share(rows, [&](std::size_t part, std::size_t first, std::size_t last) {
    ScoreSums sums;
    for (std::size_t row = first; row < last; ++row) {
      sums.add(fit.residuals[row] * fit.residuals[row], fit.leverage[row], shape.slope(row),
               shape.at(row, share));
    }
    parts[part] = sums;
  });
  ScoreSums total;
  for (const ScoreSums& part : parts) {
    total.squares.add(part.squares.value());
    total.pull.add(part.pull.value());
    total.expected.add(part.expected.value());
  }
  const double factor = total.squares.value() / dof;
  return factor > 0.0 ? total.pull.value() / factor - total.expected.value() : 0.0;
}

// The root of the score by regula falsi in the Illinois form (Dowell & Jarratt, BIT 11, 1971).
double best_share(const VarianceShape& shape, const WeightedFit& fit, double dof) {
  const auto score = [&](double share) { return share_score(shape, fit, dof, share); };
  double low = 0.0;
  double high = kLargestShare;
  double score_low = score(low);
  if (score_low <= 0.0) return low;
  double score_high = score(high);
  if (score_high >= 0.0) return high;
  double share = low;
  for (int trial = 0, side = 0; trial < kTrials; ++trial) {
    const double next = low + (high - low) * (score_low / (score_low - score_high));
    if (!(std::abs(next - share) > 0x1p-50 * next)) return next;
    share = next;
    const double value = score(share);
    if (value == 0.0) return share;
    double& end = value > 0.0 ? low : high;
    double& score_end = value > 0.0 ? score_low : score_high;
    double& score_other = value > 0.0 ? score_high : score_low;
    const int side_now = value > 0.0 ? 1 : -1;
    if (side_now == side) score_other *= 0.5;
    end = share;
    score_end = value;
    side = side_now;
  }
  return share;
}

}  // namespace

GrowingVarianceFit fit_growing_variance(const RegressionRows& rows, std::span<const double> growth,
                                        const GrowingVarianceOptions& options) {
  if (rows.rows() <= rows.regressors() || growth.size() != rows.rows()) {
    throw std::invalid_argument("a variance needs more rows than columns and one growth a row");
  }
  const VarianceShape shape(growth);
  const auto dof = static_cast<double>(rows.rows() - rows.regressors());
  const bool varies = shape.varies();
  double share = 0.0;
  double step = 0.0;
  GrowingVarianceFit result;
  result.fit = solve_weighted_least_squares(rows, shape.weights(share));
  do {
    if (!varies) break;
    const double next = best_share(shape, result.fit, dof);
    step = std::abs(next - share);
    share = next;
    result.fit = solve_weighted_least_squares(rows, shape.weights(share));
    ++result.iterations;
  } while (step > options.tolerance && result.iterations < options.iterations);

  result.variance = result.fit.weighted_rss / dof;
  result.base = result.variance * (1.0 - share);
  result.slope = varies ? result.variance * share / shape.mean() : 0.0;
  const bool converged = step <= options.tolerance;
  result.termination = {
      .cause = converged ? Cause::converged : Cause::iteration_limit,
      .reason = fmt::format(
          "{} after {} rounds: the growing share of the variance is {:.6g} and moved by {:.1e}",
          converged ? "converged" : "stopped at the limit of rounds", result.iterations, share, step)};
  return result;
}

GrowingVarianceFit fit_growing_variance(const Matrix& design, std::span<const double> y,
                                        std::span<const double> growth,
                                        const GrowingVarianceOptions& options) {
  return fit_growing_variance(MatrixRows(design, y), growth, options);
}

}  // namespace proofmass
