// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/deletion_covariance.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "proofmass/numeric/linear/gram_matrix.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"
#include "proofmass/numeric/linear/orthonormal_rows_internal.hpp"
#include "proofmass/numeric/linear/rank_analysis.hpp"

namespace proofmass {
namespace {

using SquareMatrix = Eigen::MatrixXd;
using Direction = Eigen::VectorXd;

// Of one: what a group leaves to the others of some direction.
constexpr double kNothingLeft = 1e-9;

double weight_of(const EstimatingRows& fit, std::size_t row) {
  return fit.weights.empty() ? 1.0 : fit.weights[row];
}
double slope_of(const EstimatingRows& fit, std::size_t row) {
  return fit.slopes.empty() ? weight_of(fit, row) : fit.slopes[row];
}

void require_sizes(const EstimatingRows& fit, std::span<const std::size_t> group) {
  const std::size_t n = fit.rows.rows();
  const auto one_a_row = [n](std::size_t size) { return size == n; };
  if (!one_a_row(fit.residuals.size()) || !(fit.weights.empty() || one_a_row(fit.weights.size())) ||
      !(fit.slopes.empty() || one_a_row(fit.slopes.size())) || !(group.empty() || one_a_row(group.size()))) {
    throw std::invalid_argument("a covariance by deletion needs a residual and a weight for each row");
  }
}

// Regressors that are orthonormal over the weighted rows; nothing where those lack full rank.
std::optional<Matrix> orthogonaliser_of(const EstimatingRows& fit) {
  const std::size_t n = fit.rows.rows();
  const WeightedRows weighted(fit.rows, fit.weights.empty()
                                            ? std::vector<double>(n, 1.0)
                                            : std::vector<double>(fit.weights.begin(), fit.weights.end()));
  const GramMatrix gram = gram_matrix(weighted);
  if (analyse_rank(gram).rank < fit.rows.regressors() || n < fit.rows.regressors()) return std::nullopt;
  return solve_normal_equations(gram, weighted).orthogonaliser;
}

// Sums over a group in terms of the orthonormal regressors.
struct Sums {
  SquareMatrix slopes;  // sum a q qᵀ
  Direction scores;     // sum w r q
  explicit Sums(Eigen::Index p) : slopes(SquareMatrix::Zero(p, p)), scores(Direction::Zero(p)) {}
  void add(double slope, double score, const Direction& q) {
    slopes.noalias() += slope * q * q.transpose();
    scores += score * q;
  }
};

// The change of the coefficients without a group; false where the others do not determine them.
bool change_without(const SquareMatrix& all, const Sums& own, Direction& change) {
  const Eigen::PartialPivLU<SquareMatrix> others(all - own.slopes);
  if (!(others.rcond() > kNothingLeft)) return false;
  change = others.solve(own.scores);
  return true;
}

struct Spread {
  SquareMatrix squares;
  std::optional<std::size_t> undetermined{};
};

// By the formula of Sherman and Morrison: each row is a change of rank one.
Spread spread_over_rows(const EstimatingRows& fit, const OrthonormalRows& rows, const SquareMatrix& all) {
  const SquareMatrix inverse = all.inverse();
  Spread spread{.squares = SquareMatrix::Zero(all.rows(), all.cols())};
  rows.for_each([&](std::size_t row, const Direction& q) {
    const Direction towards = inverse * q;
    const double left = 1.0 - slope_of(fit, row) * q.dot(towards);
    if (!(left > kNothingLeft)) {
      if (!spread.undetermined) spread.undetermined = row;
      return;
    }
    const double factor = weight_of(fit, row) * fit.residuals[row] / left;
    spread.squares.noalias() += (factor * factor) * towards * towards.transpose();
  });
  return spread;
}

// Sums of the groups from `first`, at most kGroupsAtOnce of them: each has a matrix of its own.
std::vector<Sums> sums_of_groups(const EstimatingRows& fit, const OrthonormalRows& rows,
                                 std::span<const std::size_t> group, std::size_t first, std::size_t count) {
  std::vector<Sums> own(count, Sums(static_cast<Eigen::Index>(rows.regressors())));
  rows.for_each([&](std::size_t row, const Direction& q) {
    if (group[row] < first || group[row] >= first + count) return;
    own[group[row] - first].add(slope_of(fit, row), weight_of(fit, row) * fit.residuals[row], q);
  });
  return own;
}

Spread spread_over_groups(const EstimatingRows& fit, const OrthonormalRows& rows, const SquareMatrix& all,
                          std::span<const std::size_t> group, std::size_t groups) {
  constexpr std::size_t kGroupsAtOnce = 4096;
  Spread spread{.squares = SquareMatrix::Zero(all.rows(), all.cols())};
  Direction change;
  for (std::size_t first = 0; first < groups; first += kGroupsAtOnce) {
    const std::size_t count = std::min(kGroupsAtOnce, groups - first);
    const std::vector<Sums> own = sums_of_groups(fit, rows, group, first, count);
    for (std::size_t g = 0; g < count; ++g) {
      if (!change_without(all, own[g], change)) {
        spread.undetermined = first + g;
        return spread;
      }
      spread.squares.noalias() += change * change.transpose();
    }
  }
  const auto number = static_cast<double>(groups);
  spread.squares *= (number - 1.0) / number;
  return spread;
}

// From the orthonormal regressors to the coefficients.
Matrix back(const SquareMatrix& squares, const OrthonormalRows& rows, std::span<const double> scales) {
  const auto p = squares.rows();
  SquareMatrix transform(p, p);
  for (Eigen::Index c = 0; c < p; ++c) {
    for (Eigen::Index r = 0; r < p; ++r) {
      const auto row = static_cast<std::size_t>(r);
      transform(r, c) = scales[row] * rows.orthogonaliser()(row, static_cast<std::size_t>(c));
    }
  }
  const SquareMatrix covariance = transform * squares * transform.transpose();
  Matrix out(static_cast<std::size_t>(p), static_cast<std::size_t>(p));
  for (Eigen::Index c = 0; c < p; ++c) {
    for (Eigen::Index r = 0; r < p; ++r) {
      const double symmetric = 0.5 * (covariance(r, c) + covariance(c, r));
      out(static_cast<std::size_t>(r), static_cast<std::size_t>(c)) = symmetric;
    }
  }
  return out;
}

}  // namespace

DeletionCovariance deletion_covariance(const EstimatingRows& fit, std::span<const std::size_t> group,
                                       std::size_t groups) {
  require_sizes(fit, group);
  std::optional<Matrix> orthogonaliser = orthogonaliser_of(fit);
  if (!orthogonaliser) return {.covariance = {}, .flat = false, .undetermined = 0};
  const OrthonormalRows rows(fit.rows, std::move(*orthogonaliser));
  const auto p = static_cast<Eigen::Index>(rows.regressors());
  SquareMatrix all = SquareMatrix::Zero(p, p);
  rows.for_each(
      [&](std::size_t row, const Direction& q) { all.noalias() += slope_of(fit, row) * q * q.transpose(); });
  const Eigen::LLT<SquareMatrix> curved(all);
  if (curved.info() != Eigen::Success || !(curved.rcond() > kNothingLeft))
    return {.covariance = {}, .flat = true};
  const Spread spread =
      group.empty() ? spread_over_rows(fit, rows, all) : spread_over_groups(fit, rows, all, group, groups);
  if (spread.undetermined) return {.covariance = {}, .flat = false, .undetermined = spread.undetermined};
  return {.covariance = back(spread.squares, rows, fit.rows.scales())};
}

}  // namespace proofmass
