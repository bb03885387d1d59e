// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/regression/orthogonal_distance.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "proofmass/numeric/regression/offset_elimination_internal.hpp"

namespace proofmass {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFirstDamping = 1e-3;
constexpr double kLeastDamping = 1e-5;
constexpr double kMostDamping = 1e12;
// A sum of squares that grew by no more than this, relative, only rounded.
constexpr double kRoundingOfSum = 1e-13;
// Where a step promises less than this of the sum of squares, rounding of long sums may hide what it gains.
constexpr double kSmall = 1e-9;
// The sum of squares stands still when it falls by less than the first fraction of itself in so many
// iterations; that is convergence when the Gauss-Newton step from there is shorter than this many standard
// errors.
constexpr double kStandstill = 1e-12;
constexpr std::size_t kStandstillIterations = 20;
constexpr double kNegligible = 1e-3;
constexpr int kOffsetSearches = 10;  // at most
// A runaway: less than the first fraction of the rows' variance is the output's own, and the parameters are
// not so many standard errors from zero, so that twice as large ones would do as well.
constexpr double kRunawayShare = 1e-6;
constexpr double kRunawaySignificance = 1e-3;
// Variation of the surface, in standard errors, below which further starts are tried.
constexpr double kWeak = 10.0;

void check(const Surface& surface, const SurfaceObservations& observed, std::size_t parameters) {
  const std::size_t rows = observed.output.size();
  const auto fits = [rows](std::span<const double> column) { return column.size() == rows; };
  const auto usable = [](double sigma) { return sigma >= 0.0 && std::isfinite(sigma); };
  bool good = observed.inputs.size() == surface.inputs() && observed.input_sigma.size() == surface.inputs() &&
              parameters == surface.parameters() && rows >= parameters && fits(observed.output_sigma) &&
              std::all_of(observed.inputs.begin(), observed.inputs.end(), fits);
  for (const auto& column : observed.input_sigma) {
    good = good && (column.empty() || fits(column)) && std::all_of(column.begin(), column.end(), usable);
  }
  for (const double sigma : observed.output_sigma) good = good && sigma > 0.0 && std::isfinite(sigma);
  if (!good) {
    throw std::invalid_argument(
        "orthogonal distance regression needs columns of one length, at least as many rows as parameters, "
        "finite sigmas that are not negative, and above zero for the output");
  }
}

// Minimises |R s - q|² + mu |D s|², D the column lengths of R.
VectorXd damped_step(const OffsetElimination::Linearised& at, double mu) {
  if (mu == 0.0) return at.triangle.triangularView<Eigen::Upper>().solve(at.rotated);
  const Index n = at.rotated.size();
  MatrixXd stacked(2 * n, n);
  stacked.topRows(n) = at.triangle;
  stacked.bottomRows(n) = (std::sqrt(mu) * at.triangle.colwise().norm()).asDiagonal();
  VectorXd target = VectorXd::Zero(2 * n);
  target.head(n) = at.rotated;
  return stacked.colPivHouseholderQr().solve(target);
}

Matrix inverse_normal(const MatrixXd& triangle) {
  const Index n = triangle.cols();
  const MatrixXd inverse = triangle.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(n, n));
  Matrix result(static_cast<std::size_t>(n), static_cast<std::size_t>(n));
  Eigen::Map<MatrixXd>(result.data(), n, n) = inverse * inverse.transpose();
  return result;
}

// The iteration: step() until it says why to stop.
class DistanceMinimiser {
 public:
  DistanceMinimiser(OffsetElimination& fitter, const OrthogonalDistanceOptions& options)
      : fitter_(fitter), options_(options) {
    const VectorXd nowhere = VectorXd::Zero(static_cast<Index>(fitter.parameters().size()));
    result_.sum_of_squares = fitter_.attempt(nowhere, 0.0).sum_of_squares;
    fitter_.accept();
    result_.history.push_back(result_.sum_of_squares);
  }

  OrthogonalDistanceFit run(const OrthogonalDistanceObserver& observer) {
    if (!std::isfinite(result_.sum_of_squares)) {
      return finish(ended(Cause::stalled, Event::start_not_finite));
    }
    while (result_.iterations < options_.iterations) {
      if (std::optional<Termination> end = iterate()) {
        if (end->cause == Cause::converged && improve_offsets()) continue;
        return finish(std::move(*end));
      }
      if (observer && !observer(result_.iterations, result_.sum_of_squares)) {
        return finish(ended(Cause::stopped, Event::stopped_by_observer));
      }
    }
    return finish(ended(Cause::iteration_limit, Event::distance_iterations_spent,
                        {{"iterations", options_.iterations}, {"length", length_}}));
  }

 private:
  // One iteration; says why to end, or nothing when there is more to gain.
  std::optional<Termination> iterate() {
    const bool advanced = advance();
    if (advanced && length_ <= limit_) {
      return ended(Cause::converged, Event::distance_step_short, {{"length", length_}, {"limit", limit_}});
    }
    const std::size_t n = result_.history.size();
    const bool still = n > kStandstillIterations && result_.history[n - 1 - kStandstillIterations] <=
                                                        (1.0 + kStandstill) * result_.sum_of_squares;
    if (advanced && !still) return std::nullopt;
    const double remaining = fitter_.linearise(0.0).rotated.norm();
    const double ratio = result_.sum_of_squares / static_cast<double>(fitter_.rows());
    if (remaining <= kNegligible * std::min(1.0, std::sqrt(ratio))) {
      return ended(
          Cause::converged, Event::distance_stands_still,
          {{"sum", result_.sum_of_squares}, {"length", remaining}, {"reduction", remaining * remaining}});
    }
    if (advanced) return std::nullopt;
    return ended(Cause::stalled, Event::distance_no_step,
                 {{"sum", result_.sum_of_squares}, {"damping", mu_}});
  }

  // Raises the damping until a step does not raise the sum of squares, and takes it; false when none does.
  bool advance() {
    for (; mu_ <= kMostDamping; mu_ = mu_ == 0.0 ? kFirstDamping : 10.0 * mu_) {
      const OffsetElimination::Linearised at = fitter_.linearise(mu_);
      const VectorXd step = damped_step(at, mu_);
      if (!step.allFinite()) continue;
      const OffsetElimination::Trial trial = fitter_.attempt(step, mu_);
      // Damping shortens steps; that is not convergence.
      length_ = (1.0 + mu_) * std::sqrt((at.triangle * step).squaredNorm() + trial.offset_step);
      limit_ = std::max(options_.tolerance, 8.0 * 0x1p-52 * at.output_size);
      if (!accepts(trial)) continue;
      take(trial);
      return true;
    }
    return false;
  }

  // Whether the trial is better. Where rounding may hide that, the gradient tells: without it, steps that
  // overshoot because the surface bends would wander for ever within what rounding is allowed.
  bool accepts(const OffsetElimination::Trial& trial) {
    if (length_ <= limit_ && trial.sum_of_squares <= limit_ * limit_) return true;
    if (trial.sum_of_squares <= (1.0 + kRoundingOfSum) * result_.sum_of_squares) return true;
    const bool small = length_ * length_ <= kSmall * result_.sum_of_squares;
    if (!small || !(trial.sum_of_squares <= (1.0 + kSmall) * result_.sum_of_squares)) return false;
    if (length_ <= limit_) return true;
    const double before = fitter_.linearise(0.0).rotated.norm();
    fitter_.accept();
    const double after = fitter_.linearise(0.0).rotated.norm();
    fitter_.accept();  // and back
    return after < before;
  }

  // At a solution, looks for better ones of single rows; true when there are any, and then stands there.
  bool improve_offsets() {
    if (!fitter_.bends() || searches_ == kOffsetSearches) return false;
    ++searches_;
    const double sum_of_squares = fitter_.search_offsets();
    if (!(sum_of_squares < (1.0 - kSmall) * result_.sum_of_squares)) return false;
    take({.sum_of_squares = sum_of_squares});
    mu_ = 0.0;
    return true;
  }

  void take(const OffsetElimination::Trial& trial) {
    fitter_.accept();
    result_.sum_of_squares = trial.sum_of_squares;
    result_.history.push_back(trial.sum_of_squares);
    ++result_.iterations;
    mu_ = mu_ > kLeastDamping ? 0.1 * mu_ : 0.0;
  }

  OrthogonalDistanceFit finish(Termination termination) {
    const OffsetElimination::Linearised end = fitter_.linearise(0.0);
    result_.termination = std::move(termination);
    result_.parameters = fitter_.parameters();
    result_.unscaled_covariance = inverse_normal(end.triangle);
    const Eigen::Map<const VectorXd> parameters(result_.parameters.data(), end.rotated.size());
    result_.variation = end.variation;
    result_.significance = (end.triangle * parameters).norm();
    result_.runaway = end.output_share < kRunawayShare && result_.significance < kRunawaySignificance;
    if (result_.runaway && result_.termination.cause == Cause::converged) {
      result_.termination = ended(Cause::stalled, Event::distance_runs_away,
                                  {{"significance", result_.significance}, {"sum", result_.sum_of_squares}});
    }
    result_.dof = fitter_.rows() - result_.parameters.size();
    result_.offsets = fitter_.offsets();
    return std::move(result_);
  }

  OffsetElimination& fitter_;
  const OrthogonalDistanceOptions& options_;
  double mu_ = 0.0;
  double length_ = 0.0;  // of the last step, in standard deviations
  double limit_ = 0.0;   // at which it counts as none
  int searches_ = 0;     // for better offsets
  OrthogonalDistanceFit result_;
};

bool settled(const OrthogonalDistanceFit& fit) {
  return fit.termination.cause == Cause::converged && fit.variation >= kWeak;
}

bool better(const OrthogonalDistanceFit& fit, const OrthogonalDistanceFit& than) {
  if (fit.termination.cause != Cause::converged) return false;
  return than.termination.cause != Cause::converged ||
         fit.sum_of_squares < (1.0 - kSmall) * than.sum_of_squares;
}

}  // namespace

OrthogonalDistanceFit fit_orthogonal_distance(const Surface& surface, const SurfaceObservations& observed,
                                              std::span<const double> start,
                                              const OrthogonalDistanceOptions& options,
                                              const OrthogonalDistanceObserver& observer) {
  check(surface, observed, start.size());
  OffsetElimination fitter(surface, observed, start);
  return DistanceMinimiser(fitter, options).run(observer);
}

OrthogonalDistanceFit fit_orthogonal_distance_from(const Surface& surface,
                                                   const SurfaceObservations& observed,
                                                   const std::vector<std::vector<double>>& starts,
                                                   const OrthogonalDistanceOptions& options,
                                                   const OrthogonalDistanceObserver& observer) {
  if (starts.empty()) throw std::invalid_argument("orthogonal distance regression needs a start");
  OrthogonalDistanceFit best = fit_orthogonal_distance(surface, observed, starts.front(), options, observer);
  double beyond = best.runaway ? best.sum_of_squares : std::numeric_limits<double>::infinity();
  std::size_t from = 0;
  for (std::size_t k = 1; k < starts.size() && (from > 0 || !settled(best)); ++k) {
    if (best.termination.cause == Cause::stopped) return best;
    OrthogonalDistanceFit fit = fit_orthogonal_distance(surface, observed, starts[k], options, observer);
    if (fit.termination.cause == Cause::stopped) return fit;
    if (fit.runaway) beyond = std::min(beyond, fit.sum_of_squares);
    if (!better(fit, best)) continue;
    best = std::move(fit);
    from = k;
  }
  if (best.termination.cause != Cause::converged) return best;
  if (from > 0) {
    best.termination.remarks.push_back(
        {.event = Event::distance_other_start, .figures = {{"start", from + 1}, {"total", starts.size()}}});
  }
  if (beyond < best.sum_of_squares) {
    best.termination.remarks.push_back({.event = Event::distance_local_minimum,
                                        .figures = {{"sum", best.sum_of_squares}, {"beyond", beyond}}});
  }
  return best;
}

}  // namespace proofmass
