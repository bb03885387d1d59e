// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/least_squares.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "proofmass/numeric/linear/column_scaling.hpp"
#include "proofmass/numeric/simd/compensated.hpp"

namespace proofmass {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kRefinements = 5;

// A design with scaled columns, its factors, and the right-hand side.
struct Problem {
  MatrixXd design;
  VectorXd scales;  // scaled column = scales * column
  VectorXd y;
  Eigen::ColPivHouseholderQR<MatrixXd> factors;
  MatrixXd triangle;  // R of the factors, n x n

  [[nodiscard]] auto upper() const { return triangle.triangularView<Eigen::Upper>(); }
  [[nodiscard]] auto lower() const { return triangle.transpose().triangularView<Eigen::Lower>(); }
};

// Coefficients of the scaled columns, and residuals.
struct Solution {
  VectorXd coefficients;
  VectorXd residuals;
};

bool full_rank(const MatrixXd& triangle) {
  MatrixXd unit = triangle;
  for (auto column : unit.colwise()) column.normalize();
  const VectorXd values = Eigen::JacobiSVD<MatrixXd>(unit).singularValues();
  // Half the tolerance: a design that analyse_rank accepts narrowly must pass here too, despite the rounding
  // of another QR.
  return values(values.size() - 1) > 0.5 * kRankTolerance * values(0);
}

Problem make_problem(const Matrix& design, std::span<const double> y) {
  const auto rows = static_cast<Index>(design.rows());
  const auto columns = static_cast<Index>(design.columns());
  if (columns == 0 || rows < columns || y.size() != design.rows()) {
    throw std::invalid_argument("least squares needs columns, as many rows, and one y a row");
  }
  if (!std::all_of(y.begin(), y.end(), [](double value) { return std::isfinite(value); })) {
    throw std::invalid_argument("the right-hand side has an element that is not finite");
  }
  const std::vector<double> scales = column_scales(design);
  Problem problem;
  problem.scales = Eigen::Map<const VectorXd>(scales.data(), columns);
  problem.design = Eigen::Map<const MatrixXd>(design.data(), rows, columns) * problem.scales.asDiagonal();
  problem.y = Eigen::Map<const VectorXd>(y.data(), rows);
  problem.factors.compute(problem.design);
  problem.triangle = problem.factors.matrixQR().topRows(columns).triangularView<Eigen::Upper>();
  if (!full_rank(problem.triangle)) throw std::invalid_argument("the design matrix lacks full column rank");
  return problem;
}

// f = y - r - A c, in twice the working precision, rounded once.
VectorXd equation_defect(const Problem& problem, const Solution& solution) {
  constexpr Index block = 1024;
  const Index rows = problem.y.size();
  VectorXd defect(rows);
  std::vector<CompensatedSum> sums(static_cast<std::size_t>(block));
  for (Index first = 0; first < rows; first += block) {
    const Index count = std::min(block, rows - first);
    for (Index r = 0; r < count; ++r) {
      auto& sum = sums[static_cast<std::size_t>(r)] = {.high = problem.y(first + r)};
      sum.add(-solution.residuals(first + r));
    }
    for (Index c = 0; c < problem.design.cols(); ++c) {
      for (Index r = 0; r < count; ++r) {
        sums[static_cast<std::size_t>(r)].add_product(problem.design(first + r, c),
                                                      -solution.coefficients(c));
      }
    }
    for (Index r = 0; r < count; ++r) defect(first + r) = sums[static_cast<std::size_t>(r)].value();
  }
  return defect;
}

// g = -Aᵀ r, in twice the working precision, rounded once.
VectorXd orthogonality_defect(const Problem& problem, const Solution& solution) {
  VectorXd defect(problem.design.cols());
  for (Index c = 0; c < problem.design.cols(); ++c) {
    CompensatedSum sum;
    for (Index r = 0; r < problem.design.rows(); ++r) {
      sum.add_product(problem.design(r, c), -solution.residuals(r));
    }
    defect(c) = sum.value();
  }
  return defect;
}

// Solves [I A; Aᵀ 0] [r; c] = [f; g] by the factors of A.
Solution solve_augmented(const Problem& problem, const VectorXd& f, const VectorXd& g) {
  const Index columns = problem.design.cols();
  const auto& permutation = problem.factors.colsPermutation();
  VectorXd rotated = problem.factors.householderQ().adjoint() * f;
  const VectorXd h = problem.lower().solve(permutation.transpose() * g);
  Solution solution;
  solution.coefficients = permutation * problem.upper().solve(rotated.head(columns) - h);
  rotated.head(columns) = h;
  solution.residuals = problem.factors.householderQ() * rotated;
  return solution;
}

// Corrections shrink by a factor of about condition * 2^-53 per round. The loop ends when they no longer
// halve.
Solution refined_solution(const Problem& problem) {
  Solution solution = solve_augmented(problem, problem.y, VectorXd::Zero(problem.design.cols()));
  double previous = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kRefinements; ++k) {
    const Solution correction =
        solve_augmented(problem, equation_defect(problem, solution), orthogonality_defect(problem, solution));
    const double size = correction.coefficients.norm() + correction.residuals.norm();
    if (!(size < 0.5 * previous)) break;
    solution.coefficients += correction.coefficients;
    solution.residuals += correction.residuals;
    if (size <= 0x1p-53 * solution.coefficients.norm()) break;
    previous = size;
  }
  return solution;
}

Matrix unscaled_covariance(const Problem& problem) {
  const Index n = problem.design.cols();
  const MatrixXd inverse = problem.upper().solve(MatrixXd::Identity(n, n));
  const auto& permutation = problem.factors.colsPermutation();
  const MatrixXd scaled = permutation * (inverse * inverse.transpose()) * permutation.transpose();
  Matrix result(static_cast<std::size_t>(n), static_cast<std::size_t>(n));
  Eigen::Map<MatrixXd>(result.data(), n, n) =
      problem.scales.asDiagonal() * scaled * problem.scales.asDiagonal();
  return result;
}

bool is_constant(std::span<const double> column) {
  return std::all_of(column.begin(), column.end(), [&](double value) { return value == column.front(); });
}

std::vector<double> variance_inflation(const Matrix& design, const Matrix& covariance) {
  bool has_constant = false;
  for (std::size_t c = 0; c < design.columns(); ++c) has_constant |= is_constant(design.column(c));
  std::vector<double> vif(design.columns(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t c = 0; c < design.columns(); ++c) {
    const auto values = design.column(c);
    if (is_constant(values)) continue;
    const Eigen::Map<const VectorXd> column(values.data(), static_cast<Index>(values.size()));
    const double centre = has_constant ? column.mean() : 0.0;
    vif[c] = (column.array() - centre).matrix().squaredNorm() * covariance(c, c);
  }
  return vif;
}

// Squared row lengths of A R⁻¹, which has orthonormal columns.
std::vector<double> leverages(const Problem& problem) {
  constexpr Index block = 1024;
  const Index rows = problem.design.rows();
  std::vector<double> result(static_cast<std::size_t>(rows));
  Eigen::Map<VectorXd> leverage(result.data(), rows);
  for (Index first = 0; first < rows; first += block) {
    const Index count = std::min(block, rows - first);
    const MatrixXd part =
        (problem.design.middleRows(first, count) * problem.factors.colsPermutation()).transpose();
    leverage.segment(first, count) = problem.lower().solve(part).colwise().squaredNorm().transpose();
  }
  return result;
}

}  // namespace

double LeastSquaresFit::residual_sd() const noexcept {
  return dof == 0 ? 0.0 : std::sqrt(rss / static_cast<double>(dof));
}

LeastSquaresFit solve_least_squares(const Matrix& design, std::span<const double> y) {
  const Problem problem = make_problem(design, y);
  const Solution solution = refined_solution(problem);
  const VectorXd coefficients = problem.scales.cwiseProduct(solution.coefficients);
  LeastSquaresFit fit;
  fit.coefficients.assign(coefficients.begin(), coefficients.end());
  fit.residuals.assign(solution.residuals.begin(), solution.residuals.end());
  fit.rss = solution.residuals.squaredNorm();
  fit.dof = design.rows() - design.columns();
  fit.unscaled_covariance = unscaled_covariance(problem);
  fit.vif = variance_inflation(design, fit.unscaled_covariance);
  fit.leverage = leverages(problem);
  return fit;
}

}  // namespace proofmass
