// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/normal_solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "proofmass/numeric/linear/gram_factor.hpp"
#include "proofmass/numeric/linear/gram_kernels.hpp"
#include "proofmass/numeric/linear/rank_analysis.hpp"
#include "proofmass/numeric/linear/row_chunks.hpp"
#include "proofmass/numeric/simd/compensated.hpp"

namespace proofmass {
namespace {

// When the sum of squared residuals is below this fraction of the terms that cancel in it, it is computed row
// by row. The sums are accurate to 1e-30 of these terms, so at least 12 digits remain above the limit.
constexpr double kCancelled = 0x1p-60;

std::vector<double> for_scaled_regressors(std::span<const double> coefficients,
                                          std::span<const double> scales) {
  std::vector<double> result(coefficients.begin(), coefficients.end());
  for (std::size_t c = 0; c < result.size(); ++c) result[c] /= scales[c];
  return result;
}

double squares_by_rows(const RegressionRows& rows, std::span<const double> scaled_coefficients) {
  constexpr std::size_t step = 32 * RowBlock::kRows;
  std::vector<CompensatedSum> sums(row_chunks(rows.rows()));
  for_each_row_chunk(rows.rows(), [&](std::size_t chunk, std::size_t first, std::size_t last) {
    std::vector<double> residuals(std::min(step, last - first));
    for (std::size_t row = first; row < last; row += step) {
      const std::size_t end = std::min(row + step, last);
      compute_residuals(rows, scaled_coefficients, row, end, residuals);
      for (std::size_t r = 0; r < end - row; ++r) sums[chunk].add_product(residuals[r], residuals[r]);
    }
  });
  CompensatedSum sum;
  for (const CompensatedSum& part : sums) sum.add(part.value());
  return sum.value();
}

void require_solvable(const GramMatrix& gram, const GramFactor& factor) {
  const std::size_t n = gram.regressors();
  if (n == 0 || gram.rows() < n) {
    throw std::invalid_argument("least squares needs columns, as many rows, and one y a row");
  }
  for (std::size_t c = 0; c <= n; ++c) {
    if (!std::isfinite(gram(c, c).value())) {
      throw std::invalid_argument("the design matrix or the response has an element that is not finite");
    }
  }
  // Half the tolerance: a design that analyse_rank accepts narrowly must pass here too.
  if (!(scaled_condition(factor.rounded()) * 0.5 * kRankTolerance < 1.0)) {
    throw std::invalid_argument("the design matrix lacks full column rank");
  }
}

// An element of R⁻¹ R⁻ᵀ, i <= j.
DoubleDouble scaled_covariance(const std::vector<DoubleDouble>& inverse, std::size_t n, std::size_t i,
                               std::size_t j) {
  DoubleDouble sum;
  for (std::size_t k = j; k < n; ++k) sum = sum + inverse[k * n + i] * inverse[k * n + j];
  return sum;
}

// (AᵀA)⁻¹ for the unscaled regressors; `scales` holds one power of two for each.
Matrix covariance_of(const std::vector<DoubleDouble>& inverse, std::span<const double> scales) {
  const std::size_t n = scales.size();
  Matrix result(n, n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i <= j; ++i) {
      result(i, j) = result(j, i) = scales[i] * scaled_covariance(inverse, n, i, j).value() * scales[j];
    }
  }
  return result;
}

// Index of the constant regressor; the number of regressors when there is none.
std::size_t constant_regressor(const GramMatrix& gram) {
  std::size_t c = 0;
  while (c < gram.regressors() && gram.least(c) != gram.greatest(c)) ++c;
  return c;
}

// `inverse` is R⁻¹.
std::vector<double> variance_inflation(const GramMatrix& gram, const GramFactor& factor,
                                       const std::vector<DoubleDouble>& inverse) {
  const std::size_t n = gram.regressors();
  const std::size_t constant = constant_regressor(gram);
  std::vector<double> vif(n, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t c = 0; c < n; ++c) {
    if (gram.least(c) == gram.greatest(c)) continue;
    DoubleDouble squares = gram(c, c);
    if (constant < n) squares = squares - gram(constant, c) * gram(constant, c) / gram(constant, constant);
    const double scale = factor.scales()[c];
    vif[c] = scale * squares.value() * scale * scaled_covariance(inverse, n, c, c).value();
  }
  return vif;
}

}  // namespace

NormalSolution solve_normal_equations(const GramMatrix& gram, const RegressionRows& rows) {
  const GramFactor factor(gram);
  require_solvable(gram, factor);
  const std::size_t n = gram.regressors();
  const std::vector<DoubleDouble> inverse = factor.inverse();
  std::vector<double> scales(factor.scales());
  for (std::size_t c = 0; c < n; ++c) scales[c] *= gram.scales()[c];
  NormalSolution solution{.coefficients = std::vector<double>(n),
                          .rss = 0.0,
                          .dof = gram.rows() - n,
                          .unscaled_covariance = covariance_of(inverse, scales),
                          .vif = {},
                          .orthogonaliser = Matrix(n, n)};
  for (std::size_t i = 0; i < n; ++i) {
    DoubleDouble sum;
    for (std::size_t k = i; k < n; ++k) {
      sum = sum + inverse[k * n + i] * factor.projection()[k];
      solution.orthogonaliser(i, k) = factor.scales()[i] * inverse[k * n + i].value();
    }
    solution.coefficients[i] = scales[i] * sum.value();
  }
  solution.rss = residual_sum_of_squares(gram, rows, solution.coefficients);
  solution.vif = variance_inflation(gram, factor, inverse);
  return solution;
}

double residual_sum_of_squares(const GramMatrix& gram, const RegressionRows& rows,
                               std::span<const double> coefficients) {
  const std::size_t n = coefficients.size();
  std::vector<double> c = for_scaled_regressors(coefficients, gram.scales());
  for (double& value : c) value = -value;
  c.push_back(1.0);
  DoubleDouble sum;
  double length = 0.0;
  for (std::size_t i = 0; i <= n; ++i) {
    DoubleDouble inner;
    for (std::size_t j = 0; j <= n; ++j) inner = inner + gram(i, j) * DoubleDouble(c[j]);
    sum = sum + inner * DoubleDouble(c[i]);
    length += std::abs(c[i]) * std::sqrt(gram(i, i).value());
  }
  if (sum.value() > kCancelled * length * length) return sum.value();
  return squares_by_rows(rows, for_scaled_regressors(coefficients, gram.scales()));
}

std::vector<double> variance_inflation(const GramMatrix& gram) {
  const GramFactor factor(gram);
  require_solvable(gram, factor);
  return variance_inflation(gram, factor, factor.inverse());
}

std::vector<double> regression_residuals(const RegressionRows& rows, std::span<const double> coefficients) {
  std::vector<double> residuals(rows.rows());
  const std::vector<double> scaled = for_scaled_regressors(coefficients, rows.scales());
  for_each_row_chunk(rows.rows(), [&](std::size_t /*chunk*/, std::size_t first, std::size_t last) {
    compute_residuals(rows, scaled, first, last, std::span(residuals).subspan(first));
  });
  return residuals;
}

std::vector<double> regression_leverages(const RegressionRows& rows, const Matrix& orthogonaliser) {
  std::vector<double> leverages(rows.rows());
  for_each_row_chunk(rows.rows(), [&](std::size_t /*chunk*/, std::size_t first, std::size_t last) {
    compute_squared_lengths(rows, orthogonaliser, first, last, std::span(leverages).subspan(first));
  });
  return leverages;
}

}  // namespace proofmass
