// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/weighted_least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "proofmass/numeric/linear/normal_solution.hpp"
#include "proofmass/numeric/simd/compensated.hpp"

namespace proofmass {
namespace {

std::vector<double> row_factors(std::span<const double> weights) {
  std::vector<double> factors;
  factors.reserve(weights.size());
  for (const double weight : weights) factors.push_back(std::sqrt(weight));
  return factors;
}

// A row of weight zero does not appear in the scaled problem, so its residual is computed from the
// coefficients.
double plain_residual(const Matrix& design, std::span<const double> y, std::span<const double> coefficients,
                      std::size_t row) {
  double residual = y[row];
  for (std::size_t c = 0; c < coefficients.size(); ++c) residual -= design(row, c) * coefficients[c];
  return residual;
}

}  // namespace

WeightedFit solve_weighted_least_squares(const Matrix& design, std::span<const double> y,
                                         std::span<const double> weights) {
  require_weights(weights, design.rows());
  if (y.size() != design.rows()) throw std::invalid_argument("weighted least squares needs one y a row");
  const std::vector<double> factors = row_factors(weights);
  Matrix scaled = design;
  std::vector<double> right(y.begin(), y.end());
  for (std::size_t c = 0; c < scaled.columns(); ++c) {
    const auto column = scaled.column(c);
    for (std::size_t r = 0; r < column.size(); ++r) column[r] *= factors[r];
  }
  for (std::size_t r = 0; r < right.size(); ++r) right[r] *= factors[r];

  LeastSquaresFit solution = solve_least_squares(scaled, right);
  WeightedFit fit{.coefficients = std::move(solution.coefficients),
                  .residuals = std::move(solution.residuals),
                  .rss = 0.0,
                  .weighted_rss = solution.rss,
                  .unscaled_covariance = std::move(solution.unscaled_covariance),
                  .leverage = std::move(solution.leverage)};
  for (std::size_t r = 0; r < fit.residuals.size(); ++r) {
    double& residual = fit.residuals[r];
    residual = factors[r] > 0.0 ? residual / factors[r] : plain_residual(design, y, fit.coefficients, r);
    fit.rss += residual * residual;
  }
  return fit;
}

WeightedFit solve_weighted_least_squares(const RegressionRows& rows, std::vector<double> weights) {
  const WeightedRows weighted(rows, std::move(weights));
  NormalSolution solution = solve_normal_equations(gram_matrix(weighted), weighted);
  WeightedFit fit{.coefficients = std::move(solution.coefficients),
                  .residuals = {},
                  .rss = 0.0,
                  .weighted_rss = solution.rss,
                  .unscaled_covariance = std::move(solution.unscaled_covariance),
                  .leverage = regression_leverages(weighted, solution.orthogonaliser)};
  fit.residuals = regression_residuals(rows, fit.coefficients);
  CompensatedSum sum;
  for (const double residual : fit.residuals) sum.add_product(residual, residual);
  fit.rss = sum.value();
  return fit;
}

}  // namespace proofmass
