// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/regression/total_least_squares.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace proofmass {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kCorrections = 3;

void check(const Matrix& design, std::span<const double> y, std::span<const double> column_sigma,
           double y_sigma) {
  const auto usable = [](double sigma) { return sigma >= 0.0 && std::isfinite(sigma); };
  const auto uncertain = [](double sigma) { return sigma > 0.0; };
  if (design.rows() < design.columns() || design.rows() != y.size() ||
      design.columns() != column_sigma.size() ||
      !std::all_of(column_sigma.begin(), column_sigma.end(), usable) ||
      std::none_of(column_sigma.begin(), column_sigma.end(), uncertain) || !usable(y_sigma) ||
      !uncertain(y_sigma)) {
    throw std::invalid_argument(
        "total least squares needs as many rows as columns, a finite sigma for each of them, and one above "
        "zero for y and at least one column");
  }
}

// The problem with exact columns first and every column in its own unit: the standard deviation for uncertain
// columns and y, the length for exact ones.
struct ScaledProblem {
  std::vector<std::size_t> order;  // index of the given column for each scaled column
  VectorXd units;                  // scaled column = column / unit
  Index exact = 0;
  MatrixXd columns;
  VectorXd y;
  double y_unit = 1.0;
};

ScaledProblem make_problem(const Matrix& design, std::span<const double> y,
                           std::span<const double> column_sigma, double y_sigma) {
  const auto rows = static_cast<Index>(design.rows());
  const auto n = static_cast<Index>(design.columns());
  const Eigen::Map<const MatrixXd> given(design.data(), rows, n);
  ScaledProblem problem{.order = std::vector<std::size_t>(design.columns()),
                        .units = VectorXd(n),
                        .columns = MatrixXd(rows, n),
                        .y = Eigen::Map<const VectorXd>(y.data(), rows) / y_sigma,
                        .y_unit = y_sigma};
  std::iota(problem.order.begin(), problem.order.end(), 0U);
  const auto first_uncertain = std::stable_partition(problem.order.begin(), problem.order.end(),
                                                     [&](std::size_t c) { return column_sigma[c] == 0.0; });
  problem.exact = first_uncertain - problem.order.begin();
  for (Index k = 0; k < n; ++k) {
    const std::size_t c = problem.order[static_cast<std::size_t>(k)];
    const auto column = given.col(static_cast<Index>(c));
    problem.units(k) = k < problem.exact ? column.norm() : column_sigma[c];
    problem.columns.col(k) = column / problem.units(k);
  }
  return problem;
}

// M = AᵀA - s² E from its factors, with E the identity on the uncertain columns and zero on the exact ones.
class ShiftedNormal {
 public:
  ShiftedNormal(const MatrixXd& triangle, Index exact, double s)
      : exact_(exact),
        r11_(triangle.topLeftCorner(exact, exact)),
        r12_(triangle.block(0, exact, exact, triangle.cols() - 1 - exact)),
        svd_(triangle.block(exact, exact, r12_.cols(), r12_.cols()), Eigen::ComputeFullV) {
    const VectorXd& values = svd_.singularValues();
    inverse_squares_ = ((values.array() - s) * (values.array() + s)).inverse();
  }
  [[nodiscard]] double smallest() const { return svd_.singularValues()(r12_.cols() - 1); }

  // M⁻¹ right, column by column.
  [[nodiscard]] MatrixXd solve(const MatrixXd& right) const {
    MatrixXd solution(right.rows(), right.cols());
    const MatrixXd reduced = r11_.transpose().triangularView<Eigen::Lower>().solve(right.topRows(exact_));
    const MatrixXd schur = right.bottomRows(r12_.cols()) - r12_.transpose() * reduced;
    solution.bottomRows(r12_.cols()) =
        svd_.matrixV() * (inverse_squares_.asDiagonal() * (svd_.matrixV().transpose() * schur));
    solution.topRows(exact_) =
        r11_.triangularView<Eigen::Upper>().solve(reduced - r12_ * solution.bottomRows(r12_.cols()));
    return solution;
  }

 private:
  Index exact_;
  MatrixXd r11_, r12_;
  Eigen::JacobiSVD<MatrixXd> svd_;
  VectorXd inverse_squares_;
};

// The upper triangle of the QR of [columns, y].
MatrixXd triangle_of(const ScaledProblem& problem) {
  const Index n = problem.columns.cols();
  MatrixXd all(problem.columns.rows(), n + 1);
  all << problem.columns, problem.y;
  const Eigen::HouseholderQR<MatrixXd> qr(all);
  MatrixXd triangle = MatrixXd::Zero(n + 1, n + 1);
  const Index kept = std::min(n + 1, all.rows());
  triangle.topRows(kept) = qr.matrixQR().topRows(kept).triangularView<Eigen::Upper>();
  return triangle;
}

// The solution from the right singular vector of the least singular value (Van Huffel & Vandewalle, algorithm
// 3.2).
VectorXd solution_by_vector(const MatrixXd& triangle, Index exact, const VectorXd& vector) {
  const Index n = triangle.cols() - 1;
  VectorXd x(n);
  x.tail(n - exact) = -vector.head(n - exact) / vector(n - exact);
  x.head(exact) = triangle.topLeftCorner(exact, exact)
                      .triangularView<Eigen::Upper>()
                      .solve(triangle.col(n).head(exact) -
                             triangle.block(0, exact, exact, n - exact) * x.tail(n - exact));
  return x;
}

double weight(const ScaledProblem& problem, const VectorXd& x) {
  return 1.0 + x.tail(x.size() - problem.exact).squaredNorm();
}

// The solution satisfies Aᵀ(y - A x) + s² E x = 0 with s² = |y - A x|² / (1 + |E x|²). Corrections by M, with
// residuals from the rows, remove the rounding errors of the factors.
void refine(const ScaledProblem& problem, const ShiftedNormal& normal, VectorXd& x) {
  const Index uncertain = x.size() - problem.exact;
  for (int k = 0; k < kCorrections; ++k) {
    const VectorXd residual = problem.y - problem.columns * x;
    const double square = residual.squaredNorm() / weight(problem, x);
    VectorXd defect = problem.columns.transpose() * residual;
    defect.tail(uncertain) += square * x.tail(uncertain);
    x += normal.solve(defect);
  }
}

TotalLeastSquaresFit in_given_columns(const ScaledProblem& problem, const VectorXd& x,
                                      const MatrixXd& covariance) {
  const std::size_t n = problem.order.size();
  TotalLeastSquaresFit fit;
  fit.coefficients.resize(n);
  fit.unscaled_covariance = Matrix(n, n);
  for (std::size_t k = 0; k < n; ++k) {
    const auto row = static_cast<Index>(k);
    const double factor = problem.y_unit / problem.units(row);
    fit.coefficients[problem.order[k]] = factor * x(row);
    for (std::size_t l = 0; l < n; ++l) {
      const auto column = static_cast<Index>(l);
      fit.unscaled_covariance(problem.order[k], problem.order[l]) =
          factor * covariance(row, column) * problem.y_unit / problem.units(column);
    }
  }
  return fit;
}

}  // namespace

double TotalLeastSquaresFit::variance_ratio() const noexcept {
  return dof == 0 ? 0.0 : smallest_singular_value * smallest_singular_value / static_cast<double>(dof);
}

TotalLeastSquaresFit solve_total_least_squares(const Matrix& design, std::span<const double> y,
                                               std::span<const double> column_sigma, double y_sigma) {
  check(design, y, column_sigma, y_sigma);
  const ScaledProblem problem = make_problem(design, y, column_sigma, y_sigma);
  const MatrixXd triangle = triangle_of(problem);
  const Index n = problem.columns.cols();
  const Index left = n + 1 - problem.exact;
  const Eigen::JacobiSVD<MatrixXd> svd(triangle.bottomRightCorner(left, left), Eigen::ComputeFullV);
  const ShiftedNormal normal(triangle, problem.exact, svd.singularValues()(left - 1));
  VectorXd x = solution_by_vector(triangle, problem.exact, svd.matrixV().col(left - 1));
  refine(problem, normal, x);
  const double s = std::sqrt((problem.y - problem.columns * x).squaredNorm() / weight(problem, x));
  MatrixXd covariance = weight(problem, x) * normal.solve(MatrixXd::Identity(n, n));
  covariance = (0.5 * (covariance + covariance.transpose())).eval();
  TotalLeastSquaresFit fit = in_given_columns(problem, x, covariance);
  fit.smallest_singular_value = s;
  fit.gap = s > 0.0 ? normal.smallest() / s : std::numeric_limits<double>::infinity();
  fit.dof = design.rows() - design.columns();
  return fit;
}

}  // namespace proofmass
