// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/regression/orthogonal_distance.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
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
// A relative increase of the sum of squares up to this is rounding.
constexpr double kRounding = 1e-13;
// When a step promises a smaller relative reduction than this, the rounding of long sums may hide its gain.
constexpr double kSmall = 1e-9;

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

// The iteration calls step() until it returns a reason to stop.
class Minimiser {
 public:
  Minimiser(OffsetElimination& fitter, const OrthogonalDistanceOptions& options)
      : fitter_(fitter), options_(options) {
    const VectorXd nowhere = VectorXd::Zero(static_cast<Index>(fitter.parameters().size()));
    result_.sum_of_squares = fitter_.attempt(nowhere, 0.0).sum_of_squares;
    fitter_.accept();
    result_.history.push_back(result_.sum_of_squares);
  }

  OrthogonalDistanceFit run(const OrthogonalDistanceObserver& observer) {
    if (!std::isfinite(result_.sum_of_squares)) {
      return finish({Cause::stalled, "the sum of squares at the start is not finite"});
    }
    while (result_.iterations < options_.iterations) {
      if (!advance()) {
        return finish({Cause::stalled, fmt::format("no step reduces the sum of squares {:.6g} up to damping "
                                                   "{:.1g}",
                                                   result_.sum_of_squares, mu_)});
      }
      if (length_ <= limit_) {
        return finish({Cause::converged, fmt::format("the last step was {:.1e} standard deviations long, at "
                                                     "or below {:.1e}",
                                                     length_, limit_)});
      }
      if (observer && !observer(result_.iterations, result_.sum_of_squares)) {
        return finish({Cause::stopped, "stopped by the observer"});
      }
    }
    return finish({Cause::iteration_limit, fmt::format("the {} iterations allowed are spent, the last step "
                                                       "was {:.1e} standard deviations long",
                                                       options_.iterations, length_)});
  }

 private:
  // Raises the damping until a step does not raise the sum of squares, and takes the step. False when none
  // does.
  bool advance() {
    for (; mu_ <= kMostDamping; mu_ = mu_ == 0.0 ? kFirstDamping : 10.0 * mu_) {
      const OffsetElimination::Linearised at = fitter_.linearise(mu_);
      const VectorXd step = damped_step(at, mu_);
      if (!step.allFinite()) continue;
      const OffsetElimination::Trial trial = fitter_.attempt(step, mu_);
      // A step that is short because of damping does not mean convergence.
      length_ = (1.0 + mu_) * std::sqrt((at.triangle * step).squaredNorm() + trial.offset_step);
      limit_ = std::max(options_.tolerance, 8.0 * 0x1p-52 * at.output_size);
      const double most = 1.0 + (length_ * length_ <= kSmall * result_.sum_of_squares ? kSmall : kRounding);
      const bool rounded = length_ <= limit_ && trial.sum_of_squares <= limit_ * limit_;
      if (!rounded && !(trial.sum_of_squares <= most * result_.sum_of_squares)) continue;
      take(trial);
      return true;
    }
    return false;
  }

  void take(const OffsetElimination::Trial& trial) {
    fitter_.accept();
    result_.sum_of_squares = trial.sum_of_squares;
    result_.history.push_back(trial.sum_of_squares);
    ++result_.iterations;
    mu_ = mu_ > kLeastDamping ? 0.1 * mu_ : 0.0;
  }

  OrthogonalDistanceFit finish(Termination termination) {
    result_.termination = std::move(termination);
    result_.parameters = fitter_.parameters();
    result_.unscaled_covariance = inverse_normal(fitter_.linearise(0.0).triangle);
    result_.dof = fitter_.rows() - result_.parameters.size();
    result_.offsets = fitter_.offsets();
    return std::move(result_);
  }

  OffsetElimination& fitter_;
  const OrthogonalDistanceOptions& options_;
  double mu_ = 0.0;
  double length_ = 0.0;  // length of the last step, in standard deviations
  double limit_ = 0.0;   // a shorter step means convergence
  OrthogonalDistanceFit result_;
};

}  // namespace

OrthogonalDistanceFit fit_orthogonal_distance(const Surface& surface, const SurfaceObservations& observed,
                                              std::span<const double> start,
                                              const OrthogonalDistanceOptions& options,
                                              const OrthogonalDistanceObserver& observer) {
  check(surface, observed, start.size());
  OffsetElimination fitter(surface, observed, start);
  return Minimiser(fitter, options).run(observer);
}

}  // namespace proofmass
