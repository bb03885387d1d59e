// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/rank_analysis.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "proofmass/numeric/linear/column_scaling.hpp"
#include "proofmass/numeric/linear/gram_factor.hpp"
#include "proofmass/numeric/linear/triangular_accumulator.hpp"

namespace proofmass {
namespace {

using Eigen::Index;

Index signed_index(std::size_t n) { return static_cast<Index>(n); }

// R of the QR decomposition of design * diag(scales), n x n, block by block of rows.
Eigen::MatrixXd triangular_factor(const Matrix& design, const Eigen::VectorXd& scales) {
  const std::size_t n = design.columns();
  const std::size_t height = std::max<std::size_t>(512, 4 * n);
  TriangularAccumulator accumulator(n);
  Matrix block(height, n);
  for (std::size_t first = 0; first < design.rows(); first += height) {
    const std::size_t rows = std::min(height, design.rows() - first);
    for (std::size_t c = 0; c < n; ++c) {
      for (std::size_t r = 0; r < rows; ++r) block(r, c) = design(first + r, c) * scales(signed_index(c));
    }
    accumulator.add(block, rows);
  }
  return Eigen::Map<const Eigen::MatrixXd>(accumulator.r().data(), signed_index(n), signed_index(n));
}

Eigen::MatrixXd with_unit_columns(Eigen::MatrixXd matrix) {
  for (auto column : matrix.colwise()) column.normalize();  // a column of zeros stays as it is
  return matrix;
}

// Largest over smallest singular value; infinity when the smallest is zero.
double condition_number(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(matrix).singularValues();
  return values(0) / values(values.size() - 1);
}

// The named columns of `matrix`, followed by `candidate`.
Eigen::MatrixXd with_candidate(const Eigen::MatrixXd& matrix, const std::vector<Index>& chosen,
                               Index candidate) {
  Eigen::MatrixXd result(matrix.rows(), signed_index(chosen.size()) + 1);
  result.leftCols(signed_index(chosen.size())) = matrix(Eigen::all, chosen);
  result.rightCols(1) = matrix.col(candidate);
  return result;
}

// The combination of a dependent column and the independent ones before it that is zero.
std::vector<double> null_vector(const Eigen::MatrixXd& unit, const std::vector<Index>& independent,
                                Index dependent) {
  Eigen::VectorXd combination = Eigen::VectorXd::Zero(unit.cols());
  combination(dependent) = 1.0;
  if (!independent.empty() && unit.col(dependent).squaredNorm() > 0.0) {
    const Eigen::MatrixXd basis = unit(Eigen::all, independent);
    combination(independent) = -basis.colPivHouseholderQr().solve(unit.col(dependent));
  }
  combination.normalize();
  return {combination.begin(), combination.end()};
}

// Goes through the columns in order and keeps each one that is independent of those kept before.
std::vector<Index> select_independent(const Eigen::MatrixXd& unit, double tolerance) {
  std::vector<Index> independent;
  // Leaving columns out never increases a condition number, so one test usually decides for all columns.
  if (unit.rows() == unit.cols() && condition_number(unit) * tolerance < 1.0) {
    independent.resize(static_cast<std::size_t>(unit.cols()));
    std::iota(independent.begin(), independent.end(), Index{0});
    return independent;
  }
  for (Index c = 0; c < unit.cols(); ++c) {
    if (unit.col(c).squaredNorm() == 0.0 || signed_index(independent.size()) == unit.rows()) continue;
    const double condition = condition_number(with_candidate(unit, independent, c));
    if (condition * tolerance < 1.0) independent.push_back(c);
  }
  return independent;
}

Eigen::Map<const Eigen::MatrixXd> as_eigen(const Matrix& matrix) {
  return {matrix.data(), signed_index(matrix.rows()), signed_index(matrix.columns())};
}

// Takes out the columns that errors of the elements could have set apart from those before them. `errors`:
// the sums of products of the errors, for the columns of unit length.
std::vector<std::size_t> take_out_hidden(const Eigen::MatrixXd& unit, const Eigen::MatrixXd& errors,
                                         std::vector<Index>& independent) {
  std::vector<std::size_t> hidden;
  std::vector<Index> kept;
  for (const Index c : independent) {
    const std::vector<double> combination = null_vector(unit, kept, c);
    const Eigen::Map<const Eigen::VectorXd> v(combination.data(), signed_index(combination.size()));
    if ((unit * v).squaredNorm() > kErrorMargin * v.dot(errors * v)) {
      kept.push_back(c);
    } else {
      hidden.push_back(static_cast<std::size_t>(c));
    }
  }
  independent = std::move(kept);
  return hidden;
}

// Of columns times `scales`, which are then brought to unit length.
Eigen::MatrixXd errors_of_unit_columns(const Matrix& errors, const Eigen::VectorXd& scales,
                                       const Eigen::MatrixXd& factor) {
  Eigen::VectorXd to_unit = scales;
  for (Index c = 0; c < factor.cols(); ++c) {
    const double length = factor.col(c).norm();
    to_unit(c) = length > 0.0 ? scales(c) / length : 0.0;
  }
  return to_unit.asDiagonal() * as_eigen(errors) * to_unit.asDiagonal();
}

// `factor` is R of the columns times `scales`.
RankAnalysis analyse_factor(const Eigen::MatrixXd& factor, const std::vector<double>& scale_values,
                            double tolerance, const Matrix* errors = nullptr) {
  const Eigen::Map<const Eigen::VectorXd> scales(scale_values.data(), signed_index(scale_values.size()));
  const Eigen::MatrixXd unit = with_unit_columns(factor);
  std::vector<Index> independent = select_independent(unit, tolerance);
  RankAnalysis result;
  if (errors != nullptr)
    result.hidden = take_out_hidden(unit, errors_of_unit_columns(*errors, scales, factor), independent);
  result.rank = independent.size();
  result.independent.assign(independent.begin(), independent.end());
  for (Index c = 0; c < unit.cols(); ++c) {
    if (std::binary_search(independent.begin(), independent.end(), c)) continue;
    const auto before = std::lower_bound(independent.begin(), independent.end(), c);
    result.null_space.push_back(null_vector(unit, {independent.begin(), before}, c));
  }
  if (!independent.empty()) {
    const Eigen::MatrixXd raw = factor * scales.cwiseInverse().asDiagonal();
    result.condition_raw = condition_number(raw(Eigen::all, independent));
    result.condition_scaled = condition_number(unit(Eigen::all, independent));
  }
  return result;
}

}  // namespace

RankAnalysis analyse_rank(const Matrix& design, double tolerance) {
  if (design.rows() == 0 || design.columns() == 0) throw std::invalid_argument("the design matrix is empty");
  const std::vector<double> scales = column_scales(design);
  const Eigen::Map<const Eigen::VectorXd> scaling(scales.data(), signed_index(scales.size()));
  return analyse_factor(triangular_factor(design, scaling), scales, tolerance);
}

namespace {

RankAnalysis analyse_gram(const GramMatrix& gram, const Matrix* errors) {
  if (gram.rows() == 0 || gram.regressors() == 0) throw std::invalid_argument("the design matrix is empty");
  for (std::size_t c = 0; c < gram.regressors(); ++c) {
    if (!std::isfinite(gram(c, c).value())) {
      throw std::invalid_argument("the design matrix has an element that is not finite");
    }
  }
  const GramFactor factor(gram);
  std::vector<double> scales = factor.scales();
  for (std::size_t c = 0; c < scales.size(); ++c) scales[c] *= gram.scales()[c];
  return analyse_factor(as_eigen(factor.rounded()), scales, kRankTolerance, errors);
}

}  // namespace

RankAnalysis analyse_rank(const GramMatrix& gram) { return analyse_gram(gram, nullptr); }

RankAnalysis analyse_rank(const GramMatrix& gram, const Matrix& errors) {
  if (errors.rows() != gram.regressors() || errors.columns() != gram.regressors())
    throw std::invalid_argument("one error a pair of regressors is needed");
  return analyse_gram(gram, &errors);
}

double scaled_condition(const Matrix& matrix) {
  return condition_number(with_unit_columns(as_eigen(matrix)));
}

}  // namespace proofmass
