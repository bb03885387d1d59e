// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/robust_residuals.hpp"

#include <cmath>
#include <cstddef>

#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"
#include "proofmass/numeric/linear/rank_analysis.hpp"
#include "proofmass/numeric/regression/robust_regression.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kRowsPerTerm = 5;

}  // namespace

std::optional<std::vector<double>> robust_residuals(const FittedRows& rows) {
  const Matrix& basis = rows.basis();
  const std::vector<std::size_t> sample = thinned_rows(rows.rows(), kSampledRows);
  if (basis.columns() == 0 || sample.size() < kRowsPerTerm * basis.columns()) return std::nullopt;
  Matrix design(sample.size(), basis.columns());
  std::vector<double> response(sample.size());
  for (std::size_t k = 0; k < sample.size(); ++k) {
    const double root = rows.weights().empty() ? 1.0 : std::sqrt(rows.weights()[sample[k]]);
    response[k] = root * rows.residuals()[sample[k]];
    for (std::size_t c = 0; c < basis.columns(); ++c) design(k, c) = root * basis(sample[k], c);
  }
  if (analyse_rank(design).rank < design.columns()) return std::nullopt;
  const RobustFit fit = fit_robustly(design, response, {.iterations = 50, .tolerance = 1e-3});
  if (fit.rank_deficient || fit.scale_floored || fit.scale_check.doubtful) return std::nullopt;
  std::vector<double> left(rows.residuals().begin(), rows.residuals().end());
  for (std::size_t c = 0; c < basis.columns(); ++c) {
    const std::span<const double> column = basis.column(c);
    for (std::size_t row = 0; row < left.size(); ++row) left[row] -= fit.coefficients[c] * column[row];
  }
  return left;
}

}  // namespace proofmass
