// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/optimise/levenberg_marquardt.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "proofmass/numeric/optimise/linearised_sum_internal.hpp"

namespace proofmass {
namespace {

using Vector = Eigen::VectorXd;

std::span<const double> view(const Vector& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

// Polishing stops when it changes the sum of squares by more than this fraction.
constexpr double kPolishable = 1e-3;

// The state of one minimisation. The iteration calls step() until it returns a reason to stop.
class Minimiser {
 public:
  Minimiser(std::unique_ptr<LinearisedSum> problem, std::span<const double> start,
            const LevenbergMarquardtOptions& options)
      : problem_(std::move(problem)),
        options_(options),
        n_(static_cast<Eigen::Index>(start.size())),
        point_(Eigen::Map<const Vector>(start.data(), n_)),
        scale_(options.scaled ? Vector(Vector::Zero(n_)) : Vector(Vector::Ones(n_))),
        mu_(options.mu) {
    result_.sum_of_squares = problem_->evaluate(point_);
    problem_->accept();
    result_.evaluations = 1;
    result_.history.push_back(result_.sum_of_squares);
  }

  LevenbergMarquardtResult run(const LevenbergMarquardtObserver& observer) {
    if (!std::isfinite(result_.sum_of_squares)) {
      return finish(ended(Cause::stalled, Event::start_not_finite));
    }
    Termination termination = iterate(observer);
    if (termination.cause == Cause::converged || termination.cause == Cause::stalled) polish(termination);
    return finish(std::move(termination));
  }

 private:
  Termination iterate(const LevenbergMarquardtObserver& observer) {
    for (;;) {
      if (result_.sum_of_squares <= options_.target) {
        return ended(Cause::target_reached, Event::descent_at_target,
                     {{"sum", result_.sum_of_squares}, {"target", options_.target}});
      }
      if (stalled()) {
        return ended(Cause::stalled, Event::descent_stalled,
                     {{"reduction", options_.stall_reduction}, {"epochs", options_.stall_window}});
      }
      if (result_.iterations >= options_.iterations) {
        return ended(Cause::iteration_limit, Event::epochs_spent);
      }
      linearise();
      if (const double norm = problem_->gradient().norm(); norm <= options_.minimum_gradient) {
        return ended(Cause::converged, Event::gradient_small,
                     {{"gradient", norm}, {"limit", options_.minimum_gradient}});
      }
      if (options_.orthogonality > 0.0 && largest_cosine() <= options_.orthogonality) {
        return ended(Cause::converged, Event::residuals_orthogonal, {{"limit", options_.orthogonality}});
      }
      if (!descend()) {
        return ended(Cause::stalled, Event::descent_no_step, {{"damping", options_.mu_max}});
      }
      if (observer && !observer(result_.iterations, view(std::as_const(point_)), result_.sum_of_squares)) {
        return ended(Cause::stopped, Event::stopped_by_observer);
      }
    }
  }

  LevenbergMarquardtResult finish(Termination termination) {
    result_.termination = std::move(termination);
    result_.point.assign(point_.data(), point_.data() + n_);
    result_.mu = mu_;
    return std::move(result_);
  }

  void linearise() {
    problem_->linearise();
    if (!options_.scaled) return;
    scale_ = (options_.scale_memory * scale_).cwiseMax(problem_->diagonal());
    // A parameter without influence would make the damped matrix singular.
    const double floor =
        std::max(scale_.maxCoeff() * problem_->least_scale(), std::numeric_limits<double>::min());
    scale_ = scale_.cwiseMax(floor);
  }

  // Raises the damping until a step reduces the sum of squares, and takes the step. False when none does.
  bool descend() {
    double raise = 2.0;
    const auto raise_damping = [&] {
      const bool by_gain = options_.damping == Damping::gain_ratio;
      mu_ *= by_gain ? std::exchange(raise, 2.0 * raise) : options_.increase;
    };
    for (; mu_ <= options_.mu_max; raise_damping()) {
      if (!problem_->factor(mu_ * scale_)) continue;
      const Vector velocity = problem_->velocity();
      Vector step = velocity;
      if (options_.geodesic_acceleration && !accelerate(velocity, step)) continue;
      if (try_step(velocity, step)) return true;
    }
    return false;
  }

  // Adds half the geodesic acceleration to the step. False when the acceleration is too large for the
  // expansion to be valid (Transtrum & Sethna 2012, eq. (15) with alpha = 0.75).
  bool accelerate(const Vector& velocity, Vector& step) {
    const std::optional<Vector> acceleration = problem_->acceleration(velocity);
    if (!acceleration) return true;
    ++result_.evaluations;
    if (!(length(*acceleration) <= 0.75 * length(velocity))) return false;
    step += 0.5 * *acceleration;
    return true;
  }

  [[nodiscard]] double length(const Vector& v) const {
    return std::sqrt((v.array().square() * scale_.array()).sum());
  }

  bool try_step(const Vector& velocity, const Vector& step) {
    const Vector trial = point_ + step;
    const double value = problem_->evaluate(trial);
    ++result_.evaluations;
    if (!(value < result_.sum_of_squares)) return false;
    problem_->accept();
    if (options_.damping == Damping::gain_ratio) {
      const double predicted = problem_->predicted_reduction(velocity);
      const double gain = (result_.sum_of_squares - value) / predicted;
      const double excess = 2.0 * gain - 1.0;
      mu_ *= std::max(1.0 / 3.0, 1.0 - excess * excess * excess);
    } else {
      mu_ *= options_.decrease;
    }
    mu_ = std::max(mu_, 1e-20);
    point_ = trial;
    result_.sum_of_squares = value;
    ++result_.iterations;
    result_.history.push_back(value);
    return true;
  }

  [[nodiscard]] bool stalled() const {
    const std::size_t window = options_.stall_window;
    if (window == 0 || result_.history.size() <= window) return false;
    const double before = result_.history[result_.history.size() - 1 - window];
    return before - result_.sum_of_squares < options_.stall_reduction * before;
  }

  // The largest cosine of the angle between the residuals and a column of the Jacobian.
  [[nodiscard]] double largest_cosine() const {
    const Eigen::ArrayXd columns = problem_->diagonal().array().sqrt();
    const Eigen::ArrayXd products = problem_->gradient().array().abs();
    return (columns > 0.0).select(products / columns, 0.0).maxCoeff() / std::sqrt(result_.sum_of_squares);
  }

  // Gauss-Newton steps judged by their own length. Near a minimum it falls by a constant factor until only
  // rounding is left (the natural monotonicity test of Deuflhard 2004, section 4.3). Two steps are allowed
  // for it to shrink, because the first may exchange the error of one direction for that of another.
  void polish(Termination& termination) {
    double previous = std::numeric_limits<double>::infinity();
    double before_that = previous;
    std::size_t steps = 0;
    for (; steps < options_.polishing_steps; ++steps) {
      linearise();
      if (!problem_->factor(Vector::Zero(n_))) break;
      const Vector velocity = problem_->velocity();
      const double size = length(velocity);
      const double predicted = problem_->predicted_reduction(velocity);
      if (!(size < before_that && predicted <= kPolishable * result_.sum_of_squares)) break;
      const Vector trial = point_ + velocity;
      const double value = problem_->evaluate(trial);
      ++result_.evaluations;
      if (!(value <= (1.0 + kPolishable) * result_.sum_of_squares)) break;
      problem_->accept();
      point_ = trial;
      result_.sum_of_squares = value;
      before_that = std::exchange(previous, size);
    }
    if (steps == 0) return;
    termination.cause = Cause::converged;
    termination.remarks.push_back({.event = Event::descent_polished, .figures = {{"steps", steps}}});
  }

  std::unique_ptr<LinearisedSum> problem_;
  const LevenbergMarquardtOptions& options_;
  Eigen::Index n_;
  Vector point_;
  Vector scale_;
  double mu_;
  LevenbergMarquardtResult result_;
};

}  // namespace

bool SumOfSquares::curvature(std::span<const double>, std::span<double>) { return false; }

LevenbergMarquardtResult minimise(SumOfSquares& problem, std::span<const double> start,
                                  const LevenbergMarquardtOptions& options,
                                  const LevenbergMarquardtObserver& observer) {
  return Minimiser(by_normal_equations(problem), start, options).run(observer);
}

LevenbergMarquardtResult minimise(ResidualProblem& problem, std::span<const double> start,
                                  const LevenbergMarquardtOptions& options,
                                  const LevenbergMarquardtObserver& observer) {
  if (problem.rows() < start.size()) {
    throw std::invalid_argument("a problem of least squares needs as many rows as parameters");
  }
  return Minimiser(by_triangular_factor(problem, start), start, options).run(observer);
}

}  // namespace proofmass
