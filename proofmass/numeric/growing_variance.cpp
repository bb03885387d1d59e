// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/growing_variance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace proofmass {
namespace {

constexpr double kLargestShare = 1.0 - 1e-6;
constexpr double kEvenGrowth = 1e-9;  // relative spread below which growth counts as the same in every row
constexpr int kBisections = 100;      // more than the 53 that doubles can use

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

// Derivative of the restricted log-likelihood by the share, the common factor of the variances at its
// maximum: sum of slope * (residual² / (factor u²) - (1 - leverage) / u), u the relative variance.
double share_score(const VarianceShape& shape, const WeightedFit& fit, double dof, double share) {
  double sum = 0.0;
  for (std::size_t row = 0; row < fit.residuals.size(); ++row) {
    sum += fit.residuals[row] * fit.residuals[row] / shape.at(row, share);
  }
  const double factor = sum / dof;
  if (!(factor > 0.0)) return 0.0;
  double score = 0.0;
  for (std::size_t row = 0; row < fit.residuals.size(); ++row) {
    const double u = shape.at(row, share);
    const double square = fit.residuals[row] * fit.residuals[row];
    score += shape.slope(row) * (square / (factor * u) - (1.0 - fit.leverage[row])) / u;
  }
  return score;
}

double best_share(const VarianceShape& shape, const WeightedFit& fit, double dof) {
  double low = 0.0;
  double high = kLargestShare;
  if (share_score(shape, fit, dof, low) <= 0.0) return low;
  if (share_score(shape, fit, dof, high) >= 0.0) return high;
  for (int k = 0; k < kBisections; ++k) {
    const double middle = 0.5 * (low + high);
    (share_score(shape, fit, dof, middle) > 0.0 ? low : high) = middle;
  }
  return low;
}

}  // namespace

GrowingVarianceFit fit_growing_variance(const Matrix& design, std::span<const double> y,
                                        std::span<const double> growth,
                                        const GrowingVarianceOptions& options) {
  if (design.rows() <= design.columns() || growth.size() != design.rows()) {
    throw std::invalid_argument("a variance needs more rows than columns and one growth a row");
  }
  const VarianceShape shape(growth);
  const auto dof = static_cast<double>(design.rows() - design.columns());
  const bool varies = shape.varies();
  double share = 0.0;
  double step = 0.0;
  GrowingVarianceFit result;
  result.fit = solve_weighted_least_squares(design, y, shape.weights(share));
  do {
    if (!varies) break;
    const double next = best_share(shape, result.fit, dof);
    step = std::abs(next - share);
    share = next;
    result.fit = solve_weighted_least_squares(design, y, shape.weights(share));
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

}  // namespace proofmass
