// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/regression/robust_regression.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "proofmass/numeric/linear/column_scaling.hpp"
#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/linear/weighted_least_squares.hpp"

namespace proofmass {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kRounds = 2;
constexpr std::size_t kStartIterations = 60;
constexpr double kStartTolerance = 1e-3;  // in scales
constexpr RobustLoss kStartLoss{.kind = LossKind::huber, .tuning = 0.25};
constexpr double kLeverageLimit = 2.0;  // times the mean leverage; the start gives rows beyond it less weight
constexpr double kLeastEigenvalue = 1e-10;
constexpr double kRoundingOfFit = 64.0 * std::numeric_limits<double>::epsilon();

// The regression in an orthonormal basis of the columns, relative to its least-squares fit: residuals of that
// fit minus basis * shift. Weighted normal equations are safe here, because only the weights affect their
// condition.
struct RobustProblem {
  MatrixXd basis;
  VectorXd remainder;  // residuals of the least-squares fit
  std::vector<double> vif;
  Matrix unscaled_covariance;  // (XᵀX)⁻¹
  std::vector<double> leverage;
  double rounding = 0.0;    // largest residual that rounding can leave of an exact fit
  double resolution = 0.0;  // of y
  double floor = 0.0;       // of the scale
};

// What the resolution of y and rounding of y and of the products that make up a fitted value leave.
double scale_floor(const Matrix& design, const std::vector<double>& coefficients, double rounding,
                   double resolution) {
  std::vector<double> sizes(design.rows(), 0.0);
  for (std::size_t c = 0; c < design.columns(); ++c) {
    for (std::size_t r = 0; r < design.rows(); ++r) sizes[r] += std::abs(design(r, c) * coefficients[c]);
  }
  const double products = *std::max_element(sizes.begin(), sizes.end());
  return std::max({rounding, kRoundingOfFit * products, resolution / std::sqrt(12.0)});
}

RobustProblem make_robust_problem(const Matrix& design, std::span<const double> y) {
  LeastSquaresFit plain = solve_least_squares(design, y);
  const auto rows = static_cast<Index>(design.rows());
  const auto columns = static_cast<Index>(design.columns());
  const std::vector<double> scales = column_scales(design);
  const MatrixXd scaled = Eigen::Map<const MatrixXd>(design.data(), rows, columns) *
                          Eigen::Map<const VectorXd>(scales.data(), columns).asDiagonal();
  const Eigen::HouseholderQR<MatrixXd> factors(scaled);
  double largest = 0.0;
  for (const double value : y) largest = std::max(largest, std::abs(value));
  const double resolution = grid_step(y);
  const double floor = scale_floor(design, plain.coefficients, kRoundingOfFit * largest, resolution);
  return {.basis = factors.householderQ() * MatrixXd::Identity(rows, columns),
          .remainder = Eigen::Map<const VectorXd>(plain.residuals.data(), rows),
          .vif = std::move(plain.vif),
          .unscaled_covariance = std::move(plain.unscaled_covariance),
          .leverage = std::move(plain.leverage),
          .rounding = kRoundingOfFit * largest,
          .resolution = resolution,
          .floor = floor};
}

// The state of the reweighting.
struct State {
  VectorXd shift;
  VectorXd residuals;
  VectorXd weights;
  double step = std::numeric_limits<double>::infinity();  // largest change of a fitted value
  std::size_t iterations = 0;
  bool rank_deficient = false;
};

// A scale below the floor says that most residuals are rounding or nothing: then the resolution speaks.
double held_scale(const RobustProblem& problem, double scale, std::span<const double> residuals) {
  if (scale >= problem.floor) return scale;
  const auto fitted = static_cast<std::size_t>(problem.basis.cols());
  return std::max(problem.floor, grouped_median_scale(residuals, fitted, problem.resolution));
}

double scale_of(const RobustProblem& problem, const State& state) {
  const auto fitted = static_cast<std::size_t>(problem.basis.cols());
  const std::span<const double> residuals(state.residuals.data(),
                                          static_cast<std::size_t>(state.residuals.size()));
  return held_scale(problem, median_scale(residuals, fitted), residuals);
}

// One step of reweighted least squares, with prior weights in addition to those of the loss.
void reweight(const RobustProblem& problem, const RobustLoss& loss, double scale, const VectorXd& prior,
              State& state) {
  for (Index r = 0; r < state.weights.size(); ++r) {
    state.weights(r) = prior(r) * loss.weight(state.residuals(r) / scale);
  }
  const MatrixXd weighted = state.weights.asDiagonal() * problem.basis;
  const MatrixXd normal = problem.basis.transpose() * weighted;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> spectrum(normal, Eigen::EigenvaluesOnly);
  if (!(spectrum.eigenvalues()(0) > kLeastEigenvalue)) {
    state.rank_deficient = true;
    return;
  }
  const VectorXd shift = normal.llt().solve(weighted.transpose() * problem.remainder);
  state.step = (problem.basis * (shift - state.shift)).cwiseAbs().maxCoeff();
  state.shift = shift;
  state.residuals = problem.remainder - problem.basis * shift;
  ++state.iterations;
}

// Mallows weights: a row with more than twice the mean leverage gets less weight, the less the higher its
// leverage.
VectorXd leverage_weights(const RobustProblem& problem) {
  VectorXd prior(problem.basis.rows());
  const double mean = static_cast<double>(problem.basis.cols()) / static_cast<double>(problem.basis.rows());
  for (Index r = 0; r < prior.size(); ++r) {
    const double leverage = problem.leverage[static_cast<std::size_t>(r)];
    prior(r) = leverage > kLeverageLimit * mean ? kLeverageLimit * mean / leverage : 1.0;
  }
  return prior;
}

using KeepGoing = std::function<bool()>;

bool asked_to_stop(const KeepGoing& keep_going) { return keep_going && !keep_going(); }

State robust_start(const RobustProblem& problem, const KeepGoing& keep_going) {
  State state{.shift = VectorXd::Zero(problem.basis.cols()),
              .residuals = problem.remainder,
              .weights = VectorXd::Ones(problem.basis.rows())};
  const VectorXd prior = leverage_weights(problem);
  while (state.iterations < kStartIterations && !asked_to_stop(keep_going)) {
    const double scale = scale_of(problem, state);
    reweight(problem, kStartLoss, scale, prior, state);
    if (state.rank_deficient || state.step <= kStartTolerance * scale) break;
  }
  return state;
}

// The loss for these residuals, and the scale that divides them.
std::pair<RobustLoss, double> tuned_loss(const RobustProblem& problem, const State& state,
                                         const RobustOptions& options) {
  const double scale = scale_of(problem, state);
  RobustLoss loss{.kind = options.loss, .tuning = options.tuning.value_or(default_tuning(options.loss))};
  if (options.loss != LossKind::student) return {loss, scale};
  const std::span<const double> residuals(state.residuals.data(),
                                          static_cast<std::size_t>(state.residuals.size()));
  const bool held = problem.resolution > 0.0 &&
                    median_scale(residuals, static_cast<std::size_t>(problem.basis.cols())) < problem.floor;
  if (held) return {loss, scale};  // the likeliest t would be the narrowest: most residuals are zero
  const StudentScale student = fit_student(residuals, scale, options.tuning.value_or(0.0));
  loss.tuning = student.dof;
  return {loss, std::max(student.scale, problem.floor)};
}

void iterate(const RobustProblem& problem, const RobustOptions& options, double scale, const RobustLoss& loss,
             State& state, Termination& termination, const KeepGoing& keep_going) {
  const VectorXd prior = VectorXd::Ones(problem.basis.rows());
  const double enough = std::max(options.tolerance * scale, problem.rounding);
  const std::size_t limit = state.iterations + options.iterations;
  do {
    if (asked_to_stop(keep_going)) {
      termination = ended(Cause::stopped, Event::stopped_on_request);
      return;
    }
    reweight(problem, loss, scale, prior, state);
  } while (!state.rank_deficient && state.step > enough && state.iterations < limit);
  const bool converged = state.step <= enough;
  termination = ended(converged ? Cause::converged : Cause::iteration_limit,
                      converged ? Event::reweighting_converged : Event::reweighting_spent,
                      {{"count", state.iterations}, {"step", state.step / scale}});
}

// Huber's asymptotic covariance over (XᵀX)⁻¹.
double variance_factor(const RobustFit& fit, double parameters) {
  const auto n = static_cast<double>(fit.residuals.size());
  double psi_squares = 0.0;
  double slope_squares = 0.0;
  for (const double residual : fit.residuals) {
    const double u = residual / fit.loss_scale;
    const double psi = fit.loss.weight(u) * u;
    const double slope = fit.loss.slope(u);
    psi_squares += psi * psi;
    slope_squares += slope * slope / n;
  }
  const double mean = fit.psi_slope;
  const double variance = std::max(0.0, slope_squares - mean * mean);
  const double k = 1.0 + parameters / n * variance / (mean * mean);
  return k * k * psi_squares / (n - parameters) * fit.loss_scale * fit.loss_scale / (mean * mean);
}

double mean_slope(const RobustFit& fit) {
  double sum = 0.0;
  for (const double residual : fit.residuals) sum += fit.loss.slope(residual / fit.loss_scale);
  return sum / static_cast<double>(fit.residuals.size());
}

// Repeats the last step on the design itself, to the accuracy of solve_least_squares.
void finish(const Matrix& design, std::span<const double> y, const RobustProblem& problem, RobustFit& fit) {
  WeightedFit last = solve_weighted_least_squares(design, y, fit.weights);
  fit.coefficients = std::move(last.coefficients);
  fit.residuals = std::move(last.residuals);
  fit.rss = last.rss;
  const double scale = median_scale(fit.residuals, design.columns());
  fit.scale_floor = problem.floor;
  fit.scale_floored = scale < problem.floor;
  fit.resolution = problem.resolution;
  fit.scale = held_scale(problem, scale, fit.residuals);
  fit.scale_check =
      check_scale(fit.residuals, design.columns(), fit.scale, std::max(problem.resolution, problem.floor));
  fit.psi_slope = mean_slope(fit);
  const double factor = variance_factor(fit, static_cast<double>(design.columns()));
  fit.covariance = scaled(problem.unscaled_covariance, factor);
}

}  // namespace

RobustFit fit_robustly(const Matrix& design, std::span<const double> y, const RobustOptions& options,
                       const std::function<bool()>& keep_going) {
  if (design.rows() <= design.columns()) {
    throw std::invalid_argument("a robust fit needs more rows than columns");
  }
  const RobustProblem problem = make_robust_problem(design, y);
  State state = robust_start(problem, keep_going);
  RobustFit fit;
  for (int round = 0; round < kRounds && !state.rank_deficient; ++round) {
    std::tie(fit.loss, fit.loss_scale) = tuned_loss(problem, state, options);
    iterate(problem, options, fit.loss_scale, fit.loss, state, fit.termination, keep_going);
    if (fit.termination.cause == Cause::stopped) return fit;
  }
  fit.weights.assign(state.weights.begin(), state.weights.end());
  fit.vif = problem.vif;
  fit.iterations = state.iterations;
  fit.rank_deficient = state.rank_deficient;
  if (!state.rank_deficient) finish(design, y, problem, fit);
  return fit;
}

}  // namespace proofmass
