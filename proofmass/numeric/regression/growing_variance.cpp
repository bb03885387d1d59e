// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/regression/growing_variance.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "proofmass/numeric/linear/row_chunks.hpp"
#include "proofmass/numeric/simd/compensated.hpp"

namespace proofmass {
namespace {

constexpr double kLargestShare = 1.0 - 1e-6;
constexpr double kEvenGrowth = 1e-9;  // relative spread below which the growth counts as equal in every row
constexpr double kNear = 1e-3;        // relative change of the fraction in one round, for the first trial
constexpr int kTrials = 100;          // trials of a fraction at most; a dozen find it to the last digits

// Relative variance 1 - fraction + fraction * growth / mean growth; its mean is 1.
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
  [[nodiscard]] double at(std::size_t row, double fraction) const { return 1.0 + fraction * slope(row); }
  [[nodiscard]] double slope(std::size_t row) const { return relative_[row] - 1.0; }
  [[nodiscard]] std::vector<double> weights(double fraction) const {
    std::vector<double> result(relative_.size());
    for (std::size_t row = 0; row < result.size(); ++row) result[row] = 1.0 / at(row, fraction);
    return result;
  }

 private:
  std::vector<double> relative_;
  double mean_ = 0.0;
};

// Sums over rows for the score, with u the relative variance: residual²/u, slope residual²/u² and slope (1 -
// leverage)/u.
struct ScoreSums {
  CompensatedSum squares, pull, expected;

  void add(const ScoreSums& other) {
    squares.add(other.squares.value());
    pull.add(other.pull.value());
    expected.add(other.expected.value());
  }
};

// A small group of rows, whose sums need only double precision.
ScoreSums score_sums(const VarianceShape& shape, const WeightedFit& fit, double fraction, std::size_t first,
                     std::size_t last) {
  double squares = 0.0;
  double pull = 0.0;
  double expected = 0.0;
  for (std::size_t row = first; row < last; ++row) {
    const double inverse = 1.0 / shape.at(row, fraction);
    const double slope = shape.slope(row) * inverse;
    const double weighted = fit.residuals[row] * fit.residuals[row] * inverse;
    squares += weighted;
    pull += slope * weighted;
    expected += slope * (1.0 - fit.leverage[row]);
  }
  return {{squares}, {pull}, {expected}};
}

// Derivative of the restricted log-likelihood by the fraction, with the common factor of the variances at its
// maximum: sum of slope * (residual² / (factor u²) - (1 - leverage) / u).
double fraction_score(const VarianceShape& shape, const WeightedFit& fit, double dof, double fraction) {
  const std::size_t rows = fit.residuals.size();
  std::vector<ScoreSums> parts(row_chunks(rows));
  for_each_row_chunk(rows, [&](std::size_t part, std::size_t first, std::size_t last) {
    for (std::size_t row = first; row < last; row += RowBlock::kRows) {
      parts[part].add(score_sums(shape, fit, fraction, row, std::min(row + RowBlock::kRows, last)));
    }
  });
  ScoreSums total;
  for (const ScoreSums& part : parts) total.add(part);
  const double factor = total.squares.value() / dof;
  return factor > 0.0 ? total.pull.value() / factor - total.expected.value() : 0.0;
}

// Two fractions between which the score changes its sign, and their scores.
struct Bracket {
  double low, high;
  double score_low, score_high;
  int side = 0;  // which end moved last

  [[nodiscard]] double between() const { return low + (high - low) * (score_low / (score_low - score_high)); }
  // Regula falsi in the Illinois form (Dowell & Jarratt, BIT 11, 1971): the score of an end that stays twice
  // is halved.
  void narrow(double fraction, double score) {
    const int moved = score > 0.0 ? 1 : -1;
    if (moved == side) (score > 0.0 ? score_high : score_low) *= 0.5;
    (score > 0.0 ? low : high) = fraction;
    (score > 0.0 ? score_low : score_high) = score;
    side = moved;
  }
};

// The root of the score. `guess`, unless zero, is tried first, from both sides.
double best_fraction(const VarianceShape& shape, const WeightedFit& fit, double dof, double guess) {
  const auto score = [&](double fraction) { return fraction_score(shape, fit, dof, fraction); };
  Bracket bracket{
      .low = 0.0, .high = kLargestShare, .score_low = score(0.0), .score_high = score(kLargestShare)};
  if (bracket.score_low <= 0.0) return bracket.low;
  if (bracket.score_high >= 0.0) return bracket.high;
  for (const double near : {guess * (1.0 - kNear), guess * (1.0 + kNear)}) {
    if (near > bracket.low && near < bracket.high) bracket.narrow(near, score(near));
  }
  double fraction = guess;
  for (int trial = 0; trial < kTrials; ++trial) {
    const double next = bracket.between();
    if (!(std::abs(next - fraction) > 0x1p-50 * next)) return next;
    fraction = next;
    bracket.narrow(fraction, score(fraction));
  }
  return fraction;
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
  double fraction = 0.0;
  double step = 0.0;
  GrowingVarianceFit result;
  result.fit = solve_weighted_least_squares(rows, shape.weights(fraction));
  do {
    if (!varies) break;
    const double next = best_fraction(shape, result.fit, dof, fraction);
    step = std::abs(next - fraction);
    fraction = next;
    result.fit = solve_weighted_least_squares(rows, shape.weights(fraction));
    ++result.iterations;
  } while (step > options.tolerance && result.iterations < options.iterations);

  result.variance = result.fit.weighted_rss / dof;
  result.base = result.variance * (1.0 - fraction);
  result.slope = varies ? result.variance * fraction / shape.mean() : 0.0;
  const bool converged = step <= options.tolerance;
  result.termination = ended(converged ? Cause::converged : Cause::iteration_limit,
                             converged ? Event::variance_converged : Event::variance_spent,
                             {{"count", result.iterations}, {"fraction", fraction}, {"step", step}});
  return result;
}

GrowingVarianceFit fit_growing_variance(const Matrix& design, std::span<const double> y,
                                        std::span<const double> growth,
                                        const GrowingVarianceOptions& options) {
  return fit_growing_variance(MatrixRows(design, y), growth, options);
}

}  // namespace proofmass
