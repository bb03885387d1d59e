// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/network/variable_projection.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "proofmass/numeric/matrix_view_internal.hpp"
#include "proofmass/numeric/network/basis_factor_internal.hpp"

namespace proofmass {
namespace {

constexpr int kPasses = 8;
// Relative errors of the sum of squares that suffice for training and for searching.
constexpr double kTraining = 1e-12;
constexpr double kSearching = 1e-4;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kRounding = 16.0 * kEpsilon;
// Number of samples in the pilot.
constexpr std::size_t kPilotRows = 4096;
// When the pilot's C is corrected for all samples, at least this fraction of the square of a column of P must
// remain; otherwise the pass over the samples is repeated.
constexpr double kLeastLeft = 1e-2;

}  // namespace

SeparablePerceptron::SeparablePerceptron(const PerceptronShape& shape, const Samples& samples)
    : SeparablePerceptron(shape, samples, kNoColumns) {}

SeparablePerceptron::SeparablePerceptron(const PerceptronShape& shape, const Samples& samples,
                                         const ColumnBlock& fixed)
    : shape_(shape),
      samples_(samples),
      fixed_(fixed),
      products_(shape.output_weights() + fixed.columns()),
      cross_(shape.hidden_weights(), shape.output_weights() + fixed.columns()),
      projection_(shape.output_weights() + fixed.columns(), shape.hidden_weights()),
      pe_(shape.hidden_weights()),
      pq_(shape.hidden_weights(), shape.output_weights() + fixed.columns()) {
  const std::size_t n = shape.output_weights() + fixed.columns();
  for (Solution* solution : {&current_, &trial_}) {
    solution->transform = Matrix(n, n);
    solution->gram_inverse = Matrix(n, n);
    solution->output_weights.assign(n, 0.0);
    solution->state = SeparableState(shape, fixed.columns(), samples);
    view(solution->transform).setIdentity();
  }
  if (current_.state.columns.keeps() || samples.rows() < 2 * kPilotRows) return;
  pilot_rows_ = std::make_unique<const SampleRows>(one_of_each_stretch(samples, fixed, kPilotRows));
  pilot_ = std::make_unique<SeparablePerceptron>(shape_, pilot_rows_->samples, pilot_rows_->fixed);
}

std::vector<double> SeparablePerceptron::all_weights(const Solution& solution) {
  std::vector<double> weights = solution.hidden_weights;
  weights.insert(weights.end(), solution.output_weights.begin(), solution.output_weights.end());
  return weights;
}

SeparableNetwork SeparablePerceptron::network(std::span<const double> weights,
                                              const Matrix& transform) const {
  return {shape_, weights, samples_, fixed_, transform};
}

void SeparablePerceptron::sum_products(Solution& solution) {
  const std::vector<double> weights = all_weights(solution);
  sum_basis_products(network(weights, solution.transform), solution.state, products_);
  for (std::size_t c = 0; c < columns(); ++c) {
    if (solution.transform(c, c) == 0.0) products_.qq(c, c) = 1.0;  // left out before
  }
}

void SeparablePerceptron::guess(std::span<const double> hidden_weights, double tolerance) {
  if (pilot_) {
    pilot_->guess(hidden_weights, tolerance);
    (void)pilot_->solve(hidden_weights, tolerance);
    trial_.transform = pilot_->trial_.transform;
    trial_.output_weights = pilot_->trial_.output_weights;
  } else {
    trial_.transform = current_.transform;
    predict(hidden_weights, trial_.output_weights);
  }
  restore_dropped(trial_.transform);
}

double SeparablePerceptron::solve(std::span<const double> hidden_weights, double tolerance) {
  const auto size = static_cast<Eigen::Index>(columns());
  trial_.hidden_weights.assign(hidden_weights.begin(), hidden_weights.end());
  Eigen::Map<Eigen::VectorXd> c(trial_.output_weights.data(), size);
  double sum = 0.0;
  trial_.state.kept = Kept::nothing;
  // Each pass finds the error e of the present weights, and corrects the weights by its normal equations on
  // q: Newton's iteration for a linear problem. It ends when rounding no longer matters. Badly conditioned
  // columns are first made orthogonal. With a good guess, and the transform of a nearby point or of the
  // pilot, one pass is usually enough.
  for (int pass = 1; pass <= kPasses; ++pass) {
    sum_products(trial_);
    if (!view(products_.qq).allFinite() || !std::isfinite(products_.ee)) {
      c.setZero();  // such weights must not be the start of another solution
      return std::numeric_limits<double>::infinity();
    }
    const double condition = invert_gram(products_.qq, trial_.gram_inverse);
    const Eigen::Map<const Eigen::VectorXd> qe(products_.qe.data(), size);
    const Eigen::VectorXd step = view(trial_.gram_inverse) * qe;
    c += view(trial_.transform) * step;
    const double change = step.dot(cview(products_.qq) * step) - 2.0 * qe.dot(step);
    sum = std::max(products_.ee + change, kEpsilon * kEpsilon * products_.ee);
    if (kEpsilon * condition * condition * products_.ee <= tolerance * sum) break;
    if (condition < kWellConditioned || std::isinf(condition) || pass > kPasses / 2) continue;
    orthonormalise(trial_.transform, products_.qq, std::sqrt(static_cast<double>(samples_.rows())));
    trial_.state.kept = Kept::activations;
    for (std::size_t k = 0; k < columns(); ++k) {
      if (trial_.transform(k, k) == 0.0) trial_.output_weights[k] = 0.0;
    }
  }
  // Output weights can be so large that rounding alone changes the output as much as the residual does. Then
  // any residual, even zero, is meaningless, so the error that rounding may hide is counted as error.
  const double rounding = kRounding * c.lpNorm<1>();
  return sum + rounding * rounding * static_cast<double>(samples_.rows());
}

void SeparablePerceptron::predict(std::span<const double> hidden_weights,
                                  std::vector<double>& output_weights) const {
  output_weights = current_.output_weights;
  if (!linearised_) return;
  const auto p = static_cast<Eigen::Index>(hidden_weights.size());
  const Eigen::Map<const Eigen::VectorXd> to(hidden_weights.data(), p);
  const Eigen::Map<const Eigen::VectorXd> from(current_.hidden_weights.data(), p);
  Eigen::Map<Eigen::VectorXd>(output_weights.data(), cview(projection_).rows()) -=
      cview(current_.transform) * (cview(projection_) * (to - from));
}

double SeparablePerceptron::evaluate(std::span<const double> hidden_weights) {
  guess(hidden_weights, kTraining);
  return solve(hidden_weights, kTraining);
}

double SeparablePerceptron::estimate(std::span<const double> hidden_weights) {
  guess(hidden_weights, kSearching);
  return solve(hidden_weights, kSearching);
}

void SeparablePerceptron::accept() {
  std::swap(current_, trial_);
  trial_.output_weights = current_.output_weights;
  linearised_ = false;
}

void SeparablePerceptron::project() {
  const std::vector<double> weights = all_weights(current_);
  sum_cross_products(network(weights, current_.transform), current_.state, cross_);
  view(projection_).noalias() = cview(current_.gram_inverse) * cview(cross_).transpose();
  linearised_ = true;
}

void SeparablePerceptron::follow(const Solution& point) {
  current_.hidden_weights = point.hidden_weights;
  current_.output_weights = point.output_weights;
  current_.transform = point.transform;
  current_.state.kept = Kept::nothing;
  sum_products(current_);
  invert_gram(products_.qq, current_.gram_inverse);
  project();
}

bool SeparablePerceptron::correct(Matrix& normal) {
  const Eigen::MatrixXd change = cview(current_.gram_inverse) * cview(pq_).transpose();
  view(projection_) += change;
  const Eigen::VectorXd before = cview(normal).diagonal();
  view(normal).triangularView<Eigen::Lower>() -= cview(pq_) * change;
  return (cview(normal).diagonal().array() >= kLeastLeft * before.array()).all();
}

// With P = D - q C, C = (qᵀq)⁻¹ qᵀD, the residual's Jacobian is -P. P is often a millionth of D, so PᵀP from
// DᵀD and Dᵀq would be rounding only. A first pass therefore finds C, and a second sums the products of P
// itself, in which the part of q that rounding leaves is a millionth of a millionth of D. A C from the pilot
// leaves a little of q, which is subtracted from the sums.
void SeparablePerceptron::linearise(Matrix& normal, std::span<double> gradient) {
  const std::vector<double> weights = all_weights(current_);
  if (pilot_) {
    pilot_->follow(current_);
    projection_ = pilot_->projection_;
    linearised_ = true;
  } else {
    project();
  }
  for (int pass = 1; pass <= kPasses; ++pass) {
    sum_projected_products(network(weights, current_.transform), current_.state, projection_, normal, pe_,
                           pilot_ ? &pq_ : nullptr);
    if (!pilot_ || correct(normal)) break;
  }
  std::transform(pe_.begin(), pe_.end(), gradient.begin(), std::negate<>());
}

std::vector<double> SeparablePerceptron::second_in_basis(std::span<const double> along) {
  const std::vector<double> weights = all_weights(current_);
  std::vector<double> products(columns()), coefficients(columns());
  sum_second_basis(network(weights, current_.transform), current_.state, along, products);
  const auto size = static_cast<Eigen::Index>(columns());
  Eigen::Map<Eigen::VectorXd>(coefficients.data(), size) =
      cview(current_.gram_inverse) * Eigen::Map<const Eigen::VectorXd>(products.data(), size);
  return coefficients;
}

// With s the second derivative of the output along x + t * direction, the output weights following: Jᵀr" =
// Pᵀs. The second derivative of the output weights changes the output within q, to which P is orthogonal.
// Their first derivative is -C direction (in q's coordinates) by the linearisation, plus the effect of the
// residual on the normal equations when the activations change.
bool SeparablePerceptron::curvature(std::span<const double> direction, std::span<double> result) {
  const auto p = static_cast<Eigen::Index>(direction.size());
  const auto n = static_cast<Eigen::Index>(columns());
  const Eigen::Map<const Eigen::VectorXd> v(direction.data(), p);
  if (!v.allFinite()) return false;
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(n);  // the activations' derivatives along direction, times e
  for (std::size_t j = 0; j < shape_.hidden; ++j) {
    const double weight = current_.output_weights[j];
    if (weight == 0.0) continue;
    double sum = direction[shape_.hidden * shape_.inputs + j] * pe_[shape_.hidden * shape_.inputs + j];
    for (std::size_t k = j * shape_.inputs; k < (j + 1) * shape_.inputs; ++k) sum += direction[k] * pe_[k];
    moved(static_cast<Eigen::Index>(j)) = sum / weight;
  }
  std::vector<double> along(direction.begin(), direction.end());
  along.resize(direction.size() + columns());
  const auto transform = cview(current_.transform);
  Eigen::Map<Eigen::VectorXd>(along.data() + p, n) =
      transform * (cview(current_.gram_inverse) * (transform.transpose() * moved) - cview(projection_) * v);

  const std::vector<double> removed = (pilot_ ? *pilot_ : *this).second_in_basis(along);
  std::vector<double> qs(columns());
  const std::vector<double> weights = all_weights(current_);
  sum_second_derivative(network(weights, current_.transform), current_.state, along, removed, result, qs);
  const Eigen::Map<const Eigen::VectorXd> q_second(qs.data(), n);
  Eigen::Map<Eigen::VectorXd> second(result.data(), p);
  second -= cview(projection_).transpose() * q_second;
  return second.allFinite();
}

}  // namespace proofmass
