// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "proofmass/numeric/matrix_view_internal.hpp"
#include "proofmass/numeric/network/basis_factor_internal.hpp"

namespace proofmass {
namespace {

// When the part of an activation outside the span of those before it is below this fraction, the activation
// counts as dependent: that part is rounding, and its coefficient could be noise of any size.
constexpr double kIndependent = 1e-12;

// Cholesky factor of a Gram matrix, shifted when rounding has made it indefinite. The columns are then nearly
// dependent, and the shift limits the coefficient of the undetermined direction.
Eigen::LLT<Eigen::MatrixXd> factorise(const Eigen::MatrixXd& gram) {
  Eigen::LLT<Eigen::MatrixXd> factor(gram);
  const double trace = gram.trace();
  for (double shift = 1e-15; factor.info() != Eigen::Success && shift < 1e-6; shift *= 10.0) {
    factor.compute(gram + shift * trace * Eigen::MatrixXd::Identity(gram.rows(), gram.cols()));
  }
  return factor;
}

// Bound of the condition number, from the factor's diagonal.
double condition_of(const Eigen::LLT<Eigen::MatrixXd>& factor) {
  const Eigen::VectorXd diagonal = factor.matrixLLT().diagonal();
  return diagonal.maxCoeff() / diagonal.minCoeff();
}

// Leaves a column out of the transform. In the Gram matrix it is replaced by an independent column of its
// own.
void leave_out(Eigen::Index c, Eigen::Ref<Eigen::MatrixXd> transform, Eigen::Ref<Eigen::MatrixXd> gram) {
  transform.col(c).setZero();
  gram.col(c).setZero();
  gram.row(c).setZero();
  gram(c, c) = 1.0;
}

// The factor of the Gram matrix without the columns that depend on earlier ones. They are removed one at a
// time, each before later columns are made orthogonal to it: its remainder is rounding, and would make those
// inaccurate.
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

// Inverse of a Gram matrix, restricted to the span of its columns when some are zero or nearly so.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& gram) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
  const Eigen::VectorXd& values = eigen.eigenvalues();
  const double cutoff = 1e-12 * values.maxCoeff();
  const Eigen::VectorXd inverse = (values.array() > cutoff).select(values.cwiseInverse(), 0.0);
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace

double invert_gram(const Matrix& gram, Matrix& inverse) {
  const Eigen::LLT<Eigen::MatrixXd> factor = factorise(view(gram));
  if (factor.info() != Eigen::Success) {
    view(inverse) = pseudo_inverse(view(gram));
    return std::numeric_limits<double>::infinity();
  }
  view(inverse) = factor.solve(Eigen::MatrixXd::Identity(view(gram).rows(), view(gram).cols()));
  return condition_of(factor);
}

void orthonormalise(Matrix& transform, Matrix& gram, double largest_norm) {
  const auto factor = factorise_independent(view(transform), view(gram), largest_norm);
  factor.matrixU().solveInPlace<Eigen::OnTheRight>(view(transform));
}

void restore_dropped(Matrix& transform) {
  for (std::size_t c = 0; c < transform.columns(); ++c) {
    if (transform(c, c) == 0.0) transform(c, c) = 1.0;
  }
}

}  // namespace proofmass
