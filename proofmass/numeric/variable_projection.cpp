// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/variable_projection.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace proofmass {
namespace {

using Map = Eigen::Map<Eigen::MatrixXd>;
using ConstMap = Eigen::Map<const Eigen::MatrixXd>;

Map view(Matrix& m) {
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
constexpr int kPasses = 4;
constexpr int kRefinements = 2;
// An activation nearer than this share to the span of those before it is taken to lie in it: what is left of
// it is rounding, and its coefficient would be noise of any size.
constexpr double kIndependent = 1e-12;
constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();

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

SeparablePerceptron::SeparablePerceptron(const PerceptronShape& shape, const Samples& samples,
                                         const ColumnBlock& fixed)
    : shape_(shape),
      samples_(samples),
      cross_(shape.output_weights() + fixed.columns(), shape.hidden_weights()) {
  const std::size_t n = shape.output_weights() + fixed.columns();
  for (Solution* solution : {&current_, &trial_, &probe_}) {
    solution->phi = ColumnBlock(n, samples.padded_rows());
    for (std::size_t c = 0; c < fixed.columns(); ++c) {
      std::copy_n(fixed.column(c), samples.padded_rows(), solution->phi.column(shape.output_weights() + c));
    }
    solution->q = ColumnBlock(n, samples.padded_rows());
    solution->residual = ColumnBlock(1, samples.padded_rows());
    solution->transform = Matrix(n, n);
    solution->gram_inverse = Matrix(n, n);
    solution->output_weights.assign(n, 0.0);
    view(solution->transform).setIdentity();
  }
}

double SeparablePerceptron::solve(std::span<const double> hidden_weights, Solution& solution) const {
  const std::size_t n = columns();
  const auto size = static_cast<Eigen::Index>(n);
  solution.hidden_weights.assign(hidden_weights.begin(), hidden_weights.end());
  hidden_activations(shape_, hidden_weights, samples_, solution.phi);

  // Cholesky QR, repeated until the columns are well conditioned (Yamamoto et al. 2015). Starting from the
  // current point's transform, one pass is usually enough.
  solution.transform = current_.transform;
  restore_dropped(view(solution.transform));
  Matrix gram(n, n);
  std::vector<double> qty(n);
  for (int pass = 1;; ++pass) {
    transform_columns(solution.phi, solution.transform, samples_, solution.q, gram, qty);
    if (!view(gram).allFinite()) return std::numeric_limits<double>::infinity();
    for (Eigen::Index c = 0; c < size; ++c) {
      if (view(solution.transform)(c, c) == 0.0) view(gram)(c, c) = 1.0;  // left out before
    }
    Eigen::LLT<Eigen::MatrixXd> factor = factorise(view(gram));
    const bool well_conditioned = factor.info() == Eigen::Success && condition_of(factor) < kWellConditioned;
    if (well_conditioned) view(solution.gram_inverse) = factor.solve(Eigen::MatrixXd::Identity(size, size));
    if (well_conditioned) break;
    if (pass == kPasses || factor.info() != Eigen::Success) {
      view(solution.gram_inverse) = pseudo_inverse(view(gram));
      break;
    }
    factor = factorise_independent(view(solution.transform), view(gram),
                                   std::sqrt(static_cast<double>(samples_.rows())));
    factor.matrixU().solveInPlace<Eigen::OnTheRight>(view(solution.transform));
  }

  // Iterative refinement: rounding in q leaves a residual that is not quite orthogonal to the activations,
  // and what is left of it would drown the last digits of progress.
  Eigen::Map<Eigen::VectorXd> c(solution.output_weights.data(), size);
  const Eigen::Map<const Eigen::VectorXd> right(qty.data(), size);
  const Eigen::MatrixXd solver = view(solution.transform) * view(solution.gram_inverse);
  c = solver * right;
  double sum = 0.0;
  for (int refinement = 0; refinement <= kRefinements; ++refinement) {
    if (refinement > 0) c += solver * right;
    sum =
        column_residual(solution.phi, solution.output_weights, samples_, solution.q, solution.residual, qty);
  }
  // Output weights so large that rounding alone moves the output by as much as the residual would make any
  // residual, zero included, meaningless: what rounding may hide counts as error.
  const double rounding = kRounding * c.lpNorm<1>();
  return sum + rounding * rounding * static_cast<double>(samples_.rows());
}

double SeparablePerceptron::evaluate(std::span<const double> hidden_weights) {
  return solve(hidden_weights, trial_);
}

void SeparablePerceptron::accept() {
  std::swap(current_, trial_);
  trial_.output_weights = current_.output_weights;
}

void SeparablePerceptron::linearise(Matrix& normal, std::span<double> gradient) {
  hidden_jacobian_cross(shape_, current_.output_weights, current_.phi, current_.q, samples_, cross_);
  view(cross_) = view(current_.gram_inverse) * view(cross_);
  projected_normal_equations(shape_, current_.output_weights, current_.phi, current_.q, cross_,
                             current_.residual, samples_, normal, gradient);
  // The kernel projects the derivative of the output; the residual is the target less the output.
  for (double& g : gradient) g = -g;
}

bool SeparablePerceptron::curvature(std::span<const double> direction, const Matrix& normal,
                                    std::span<const double> gradient, std::span<double> result) {
  constexpr double kStep = 0.1;  // of the direction (Transtrum & Sethna 2012)
  std::vector<double> ahead(current_.hidden_weights);
  for (std::size_t k = 0; k < ahead.size(); ++k) ahead[k] += kStep * direction[k];
  if (!std::isfinite(solve(ahead, probe_))) return false;

  const auto p = static_cast<Eigen::Index>(ahead.size());
  Eigen::VectorXd dt_residual(p);
  std::vector<double> qt_residual(columns());
  hidden_jacobian_transposed(shape_, current_.output_weights, current_.phi, current_.q, probe_.residual,
                             samples_, {dt_residual.data(), ahead.size()}, qt_residual);
  const Eigen::Map<const Eigen::VectorXd> qt(qt_residual.data(),
                                             static_cast<Eigen::Index>(qt_residual.size()));
  // Jᵀ r(x + h v) with J = -(D - q cross).
  const Eigen::VectorXd ahead_gradient = -(dt_residual - view(cross_).transpose() * qt);
  const Eigen::Map<const Eigen::VectorXd> v(direction.data(), p);
  const Eigen::Map<const Eigen::VectorXd> g(gradient.data(), p);
  Eigen::Map<Eigen::VectorXd>(result.data(), p) =
      (2.0 / kStep) * ((ahead_gradient - g) / kStep - ConstMap(normal.data(), p, p) * v);
  return true;
}

}  // namespace proofmass
