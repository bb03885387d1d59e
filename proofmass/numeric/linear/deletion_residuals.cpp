// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/deletion_residuals.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "proofmass/numeric/linear/gram_matrix.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"
#include "proofmass/numeric/linear/orthonormal_rows_internal.hpp"
#include "proofmass/numeric/linear/rank_analysis.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kGroupsAtOnce = 4096;  // each has a matrix of its own
constexpr double kUndetermined = 1e-9;       // of one: what a row or group leaves to the others

using Vector = Eigen::VectorXd;

// What a group takes from the sums, in terms of the orthonormal regressors.
struct GroupSums {
  Eigen::MatrixXd squares;  // QᵀWQ
  Vector products;          // QᵀWr, and then (I - QᵀWQ)⁻¹ QᵀWr
};

// False when the others do not determine the coefficients.
bool solve(GroupSums& sums) {
  const auto p = sums.products.size();
  const Eigen::LLT<Eigen::MatrixXd> left(Eigen::MatrixXd::Identity(p, p) - sums.squares);
  if (left.info() != Eigen::Success) return false;
  const double least = left.matrixLLT().diagonal().minCoeff();
  if (!(least * least > kUndetermined)) return false;
  sums.products = left.solve(sums.products);
  return true;
}

DeletionResiduals delete_rows(const RegressionRows& rows, std::span<const double> residuals,
                              const Matrix& orthogonaliser) {
  DeletionResiduals deleted{.residuals = regression_leverages(rows, orthogonaliser)};
  for (std::size_t row = 0; row < residuals.size(); ++row) {
    const double left = 1.0 - deleted.residuals[row];
    const bool determined = left > kUndetermined;
    deleted.residuals[row] = determined ? residuals[row] / left : std::numeric_limits<double>::quiet_NaN();
    if (!determined) ++deleted.undetermined;
  }
  return deleted;
}

// Residuals of the rows of the groups from `first`, at most kGroupsAtOnce of them, into `deleted`.
void delete_some(const OrthonormalRows& rows, std::span<const double> residuals,
                 std::span<const double> weights, std::span<const std::size_t> group, std::size_t first,
                 std::vector<GroupSums> sums, DeletionResiduals& deleted) {
  const auto is_here = [&](std::size_t row) {
    return group[row] >= first && group[row] < first + sums.size();
  };
  rows.for_each([&](std::size_t row, const Vector& q) {
    if (!is_here(row)) return;
    const double w = weights.empty() ? 1.0 : weights[row];
    GroupSums& own = sums[group[row] - first];
    own.squares.noalias() += w * q * q.transpose();
    own.products += w * residuals[row] * q;
  });
  std::vector<bool> determined;
  for (GroupSums& own : sums) {
    determined.push_back(solve(own));
    if (!determined.back()) ++deleted.undetermined;
  }
  rows.for_each([&](std::size_t row, const Vector& q) {
    if (!is_here(row)) return;
    const std::size_t own = group[row] - first;
    deleted.residuals[row] = determined[own] ? residuals[row] + q.dot(sums[own].products)
                                             : std::numeric_limits<double>::quiet_NaN();
  });
}

DeletionResiduals delete_groups(const OrthonormalRows& rows, std::span<const double> residuals,
                                std::span<const double> weights, std::span<const std::size_t> group,
                                std::size_t groups) {
  const auto p = static_cast<Eigen::Index>(rows.regressors());
  DeletionResiduals deleted{.residuals = std::vector<double>(residuals.size())};
  for (std::size_t first = 0; first < groups; first += kGroupsAtOnce) {
    const std::size_t count = std::min(kGroupsAtOnce, groups - first);
    delete_some(rows, residuals, weights, group, first,
                std::vector<GroupSums>(count, {Eigen::MatrixXd::Zero(p, p), Vector::Zero(p)}), deleted);
  }
  return deleted;
}

}  // namespace

DeletionResiduals deletion_residuals(const RegressionRows& rows, std::span<const double> residuals,
                                     std::span<const double> weights, std::span<const std::size_t> group,
                                     std::size_t groups) {
  const auto one_a_row = [&rows](std::size_t size) { return size == rows.rows(); };
  if (!one_a_row(residuals.size()) || !(weights.empty() || one_a_row(weights.size())) ||
      !(group.empty() || one_a_row(group.size()))) {
    throw std::invalid_argument("deletion needs a residual, weight and group for each row");
  }
  const WeightedRows weighted(rows, weights.empty() ? std::vector<double>(rows.rows(), 1.0)
                                                    : std::vector<double>(weights.begin(), weights.end()));
  const RegressionRows& summed = weights.empty() ? rows : static_cast<const RegressionRows&>(weighted);
  const GramMatrix gram = gram_matrix(summed);
  if (analyse_rank(gram).rank < rows.regressors() || rows.rows() < rows.regressors()) {
    return {.residuals = std::vector<double>(rows.rows(), std::numeric_limits<double>::quiet_NaN()),
            .undetermined = group.empty() ? rows.rows() : groups};
  }
  Matrix orthogonaliser = solve_normal_equations(gram, summed).orthogonaliser;
  if (group.empty()) return delete_rows(summed, residuals, orthogonaliser);
  return delete_groups(OrthonormalRows(rows, std::move(orthogonaliser)), residuals, weights, group, groups);
}

}  // namespace proofmass
