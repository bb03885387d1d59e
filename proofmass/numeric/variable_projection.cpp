// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/variable_projection.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace proofmass {
namespace {

using Map = Eigen::Map<Eigen::MatrixXd>;
using ConstMap = Eigen::Map<const Eigen::MatrixXd>;

Map view(Matrix& m) {
  return {m.data(), static_cast<Eigen::Index>(m.rows()), static_cast<Eigen::Index>(m.columns())};
}

ConstMap cview(const Matrix& m) {
  return {m.data(), static_cast<Eigen::Index>(m.rows()), static_cast<Eigen::Index>(m.columns())};
}

// Cholesky factor of a Gram matrix, shifted when rounding has made it indefinite: the columns then span less
// than they seem to, and the shift keeps the lost direction's coefficient bounded.
Eigen::LLT<Eigen::MatrixXd> factorise(const Eigen::MatrixXd& gram) {
  Eigen::LLT<Eigen::MatrixXd> factor(gram);
  const double trace = gram.trace();
  for (double shift = 1e-15; factor.info() != Eigen::Success && shift < 1e-6; shift *= 10.0) {
    factor.compute(gram + shift * trace * Eigen::MatrixXd::Identity(gram.rows(), gram.cols()));
  }
  return factor;
}

// Bound of the condition number that the factor's diagonal shows.
double condition_of(const Eigen::LLT<Eigen::MatrixXd>& factor) {
  const Eigen::VectorXd diagonal = factor.matrixLLT().diagonal();
  return diagonal.maxCoeff() / diagonal.minCoeff();
}

// Columns this well conditioned lose no digit that matters to their own normal equations.
constexpr double kWellConditioned = 30.0;
constexpr int kPasses = 8;
// Relative errors of the sum of squares that are good enough to train by, and to search by.
constexpr double kTraining = 1e-12;
constexpr double kSearching = 1e-4;
// An activation nearer than this share to the span of those before it is taken to lie in it: what is left of
// it is rounding, and its coefficient would be noise of any size.
constexpr double kIndependent = 1e-12;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kRounding = 16.0 * kEpsilon;

// Leaves a column out of the transform; in the Gram matrix it stands as one of its own.
void leave_out(Eigen::Index c, Eigen::Ref<Eigen::MatrixXd> transform, Eigen::Ref<Eigen::MatrixXd> gram) {
  transform.col(c).setZero();
  gram.col(c).setZero();
  gram.row(c).setZero();
  gram(c, c) = 1.0;
}

// The factor of the Gram matrix without the columns that depend on earlier ones. They go one at a time, each
// before the later ones are made orthogonal to it: it is rounding, and would spoil them.
Eigen::LLT<Eigen::MatrixXd> factorise_independent(Eigen::Ref<Eigen::MatrixXd> transform,
                                                  const Eigen::Ref<Eigen::MatrixXd>& gram,
                                                  double largest_norm) {
  auto factor = factorise(gram);
  for (Eigen::Index c = 0; c < transform.cols(); ++c) {
    const double scale = std::abs(transform(c, c) / factor.matrixLLT()(c, c));
    if (scale * largest_norm * kIndependent < 1.0) continue;
    leave_out(c, transform, gram);
    factor = factorise(gram);
  }
  return factor;
}

// Gives columns left out another chance.
void restore_dropped(Eigen::Ref<Eigen::MatrixXd> transform) {
  for (Eigen::Index c = 0; c < transform.cols(); ++c) {
    if (transform(c, c) == 0.0) transform(c, c) = 1.0;
  }
}

// Inverse of a Gram matrix, on the span of its columns alone when some are zero or nearly so.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& gram) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
  const Eigen::VectorXd& values = eigen.eigenvalues();
  const double cutoff = 1e-12 * values.maxCoeff();
  const Eigen::VectorXd inverse = (values.array() > cutoff).select(values.cwiseInverse(), 0.0);
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

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
      pe_(shape.hidden_weights()) {
  const std::size_t n = shape.output_weights() + fixed.columns();
  for (Solution* solution : {&current_, &trial_}) {
    solution->transform = Matrix(n, n);
    solution->gram_inverse = Matrix(n, n);
    solution->output_weights.assign(n, 0.0);
    solution->state = SeparableState(shape, fixed.columns(), samples);
    view(solution->transform).setIdentity();
  }
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

void SeparablePerceptron::orthonormalise(Solution& solution) {
  const auto factor = factorise_independent(view(solution.transform), view(products_.qq),
                                            std::sqrt(static_cast<double>(samples_.rows())));
  factor.matrixU().solveInPlace<Eigen::OnTheRight>(view(solution.transform));
  solution.state.kept = Kept::activations;
  for (std::size_t k = 0; k < columns(); ++k) {
    if (solution.transform(k, k) == 0.0) solution.output_weights[k] = 0.0;
  }
}

double SeparablePerceptron::solve(std::span<const double> hidden_weights, double tolerance,
                                  Solution& solution) {
  const auto size = static_cast<Eigen::Index>(columns());
  solution.hidden_weights.assign(hidden_weights.begin(), hidden_weights.end());
  solution.transform = current_.transform;
  restore_dropped(view(solution.transform));
  Eigen::Map<Eigen::VectorXd> c(solution.output_weights.data(), size);
  double sum = 0.0;
  solution.state.kept = Kept::nothing;
  // Each pass finds the error e of the weights so far, and the weights' correction from its normal equations
  // on q: Newton's iteration for a linear problem, which ends when rounding no longer matters. Columns that
  // are badly conditioned are first made orthogonal by Cholesky QR (Yamamoto et al. 2015). From a good guess
  // and the current point's transform one pass is usually enough.
  for (int pass = 1; pass <= kPasses; ++pass) {
    sum_products(solution);
    if (!view(products_.qq).allFinite() || !std::isfinite(products_.ee)) {
      c.setZero();  // nobody may start from such weights
      return std::numeric_limits<double>::infinity();
    }
    const Eigen::LLT<Eigen::MatrixXd> factor = factorise(view(products_.qq));
    const bool factored = factor.info() == Eigen::Success;
    if (factored) {
      view(solution.gram_inverse) = factor.solve(Eigen::MatrixXd::Identity(size, size));
    } else {
      view(solution.gram_inverse) = pseudo_inverse(view(products_.qq));
    }
    const Eigen::Map<const Eigen::VectorXd> qe(products_.qe.data(), size);
    const Eigen::VectorXd step = view(solution.gram_inverse) * qe;
    c += view(solution.transform) * step;
    const double change = step.dot(cview(products_.qq) * step) - 2.0 * qe.dot(step);
    sum = std::max(products_.ee + change, kEpsilon * kEpsilon * products_.ee);
    const double condition = factored ? condition_of(factor) : std::numeric_limits<double>::infinity();
    if (kEpsilon * condition * condition * products_.ee <= tolerance * sum) break;
    if (condition < kWellConditioned || !factored || pass > kPasses / 2) continue;
    orthonormalise(solution);
  }
  // Output weights so large that rounding alone moves the output by as much as the residual would make any
  // residual, zero included, meaningless: what rounding may hide counts as error.
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
  predict(hidden_weights, trial_.output_weights);
  return solve(hidden_weights, kTraining, trial_);
}

double SeparablePerceptron::estimate(std::span<const double> hidden_weights) {
  predict(hidden_weights, trial_.output_weights);
  return solve(hidden_weights, kSearching, trial_);
}

void SeparablePerceptron::accept() {
  std::swap(current_, trial_);
  trial_.output_weights = current_.output_weights;
  linearised_ = false;
}

// With P = D - q C, C = (qᵀq)⁻¹ qᵀD, the residual's Jacobian is -P. What is left of a column of D is often a
// millionth of it: PᵀP from DᵀD and Dᵀq would be rounding. So a first pass finds C, a second sums what is
// left; what rounding has left of q in it is a millionth of that again.
void SeparablePerceptron::linearise(Matrix& normal, std::span<double> gradient) {
  const std::vector<double> weights = all_weights(current_);
  const SeparableNetwork here = network(weights, current_.transform);
  sum_cross_products(here, current_.state, cross_);
  view(projection_).noalias() = cview(current_.gram_inverse) * cview(cross_).transpose();
  sum_projected_products(here, current_.state, projection_, normal, pe_);
  std::transform(pe_.begin(), pe_.end(), gradient.begin(), std::negate<>());
  linearised_ = true;
}

// With s the second derivative of the output along x + t * direction, the output weights following: Jᵀr" =
// Pᵀs. The output weights' own second derivative moves the output within q, which P is orthogonal to. Their
// first one is -C direction (in q's coordinates), as the linearisation has it, and what the residual adds to
// the normal equations when the activations move.
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

  std::vector<double> qs(columns());
  const std::vector<double> weights = all_weights(current_);
  sum_second_derivative(network(weights, current_.transform), current_.state, along, current_.gram_inverse,
                        result, qs);
  const Eigen::Map<const Eigen::VectorXd> q_second(qs.data(), n);
  Eigen::Map<Eigen::VectorXd> second(result.data(), p);
  second -= cview(projection_).transpose() * q_second;
  return second.allFinite();
}

}  // namespace proofmass
