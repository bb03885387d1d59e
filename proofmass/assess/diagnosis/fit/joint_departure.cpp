// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/joint_departure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "proofmass/assess/diagnosis/record/term_space.hpp"
#include "proofmass/numeric/linear/least_squares.hpp"

namespace proofmass {
namespace {

constexpr double kLeastDofLeft = 3.0;
constexpr double kPlausibleTogether = 1e-3;  // above it the second test cannot make a finding
constexpr double kLeastLeverageLeft = 1e-6;

// The variance of each row's noise, from what the columns leave.
struct RowVariance {
  std::vector<double> values;
  double dof = 0.0;  // least that stands behind one of them
};

RowVariance variance_by_row(const FittedRows& left) {
  RowVariance variance{.values = std::vector<double>(left.rows()), .dof = static_cast<double>(left.dof())};
  for (std::size_t row = 0; row < left.rows(); ++row) {
    const double room = std::max(1.0 - left.leverages()[row], kLeastLeverageLeft);
    variance.values[row] = std::pow(std::max(std::abs(left.residuals()[row]), left.rounding()) / room, 2);
  }
  return variance;
}

RowVariance variance_by_group(const FittedRows& left, std::span<const std::vector<std::size_t>> groups) {
  RowVariance variance = variance_by_row(left);
  for (const std::vector<std::size_t>& group : groups) {
    double squares = 0.0;
    double room = 0.0;
    for (const std::size_t row : group) {
      squares += left.residuals()[row] * left.residuals()[row];
      room += 1.0 - left.leverages()[row];
    }
    variance.dof = std::min(variance.dof, room);
    const double least = left.rounding() * left.rounding();
    for (const std::size_t row : group)
      variance.values[row] = std::max(squares / std::max(room, 1e-3), least);
  }
  return variance;
}

// (Wᵀr)ᵀ (Wᵀ D W)⁻¹ Wᵀr for W the columns, r the residuals and D the variances.
double wald_statistic(const Matrix& columns, std::span<const double> residuals, const RowVariance& variance) {
  Matrix design = columns;
  std::vector<double> response(residuals.begin(), residuals.end());
  for (std::size_t row = 0; row < response.size(); ++row) {
    const double sd = std::sqrt(std::max(variance.values[row], 1e-300));
    response[row] /= sd;
    for (std::size_t c = 0; c < design.columns(); ++c) design(row, c) *= sd;
  }
  const std::vector<double> solution = solve_least_squares(design, response).coefficients;
  double statistic = 0.0;
  for (std::size_t c = 0; c < columns.columns(); ++c) {
    const std::span<const double> column = columns.column(c);
    statistic += solution[c] * dot(column, residuals);
  }
  return statistic;
}

}  // namespace

ColumnsBeyond columns_beyond(const FittedRows& rows, std::span<const std::vector<double>> columns,
                             double least_left) {
  std::vector<std::vector<double>> kept;
  ColumnsBeyond beyond;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    std::vector<double> values = columns[k];
    const double before = sum_of_squares(values);
    for (int pass = 0; pass < 2; ++pass) {  // the second removes what rounding left of the first
      values = rows.beyond_terms(std::move(values));
      for (const std::vector<double>& other : kept) {
        const double along = dot(other, values);
        for (std::size_t row = 0; row < values.size(); ++row) values[row] -= along * other[row];
      }
    }
    const double size = sum_of_squares(values);
    if (!(size > least_left * before)) continue;
    for (double& value : values) value /= std::sqrt(size);
    kept.push_back(std::move(values));
    beyond.kept.push_back(k);
  }
  beyond.orthonormal = Matrix(rows.rows(), kept.size());
  for (std::size_t c = 0; c < kept.size(); ++c)
    std::copy(kept[c].begin(), kept[c].end(), beyond.orthonormal.column(c).begin());
  return beyond;
}

double joint_probability(const FittedRows& rows, const Matrix& columns,
                         std::span<const std::vector<std::size_t>> groups) {
  const auto count = static_cast<double>(columns.columns());
  const double dof = static_cast<double>(rows.dof()) - count;
  if (count < 1.0 || dof < kLeastDofLeft) return 1.0;
  const FittedRows left = rows.with_columns(columns);
  const double rest = std::max(sum_of_squares(left.residuals()),
                               static_cast<double>(rows.rows()) * std::pow(rows.rounding(), 2));
  const double explained = std::max(0.0, sum_of_squares(rows.residuals()) - sum_of_squares(left.residuals()));
  const double alike = fisher_probability(explained / count / (rest / dof), count, dof);
  if (alike > kPlausibleTogether) return alike;
  const RowVariance variance = groups.empty() ? variance_by_row(left) : variance_by_group(left, groups);
  const double statistic = wald_statistic(columns, rows.residuals(), variance);
  return std::max(alike, fisher_probability(std::max(0.0, statistic) / count, count, variance.dof));
}

}  // namespace proofmass
