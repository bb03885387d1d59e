// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/serial_correlation.hpp"

#include <cmath>
#include <cstddef>

namespace proofmass {
namespace {

constexpr double kUnlikelyCorrelation = 5.0;  // standard errors
constexpr std::size_t kLeastCorrelationDof = 30;

// The sum over neighbouring rows of the elements of the hat matrix, with its sign turned, is what the fit
// makes the sum of their residuals' products, in units of the noise's variance.
double made_by_fit(const Matrix& basis) {
  double sum = 0.0;
  for (std::size_t c = 0; c < basis.columns(); ++c) {
    const std::span<const double> column = basis.column(c);
    for (std::size_t row = 1; row < column.size(); ++row) sum -= column[row - 1] * column[row];
  }
  return sum;
}

}  // namespace

std::optional<Finding> find_serial_correlation(const FittedRows& rows) {
  if (rows.dof() < kLeastCorrelationDof) return std::nullopt;
  const std::span<const double> r = rows.bounded();
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t row = 1; row < r.size(); ++row) {
    const double product = r[row - 1] * r[row];
    sum += product;
    squares += product * product;
  }
  sum -= rows.bounded_variance() * made_by_fit(rows.basis());
  if (!(sum > kUnlikelyCorrelation * std::sqrt(squares))) return std::nullopt;
  const double correlation = sum / (rows.bounded_variance() * static_cast<double>(r.size() - 1));
  return Finding{.code = Code::residuals_correlated,
                 .severity = Severity::warning,
                 .figures = {{"correlation", correlation}, {"errors", sum / std::sqrt(squares)}}};
}

}  // namespace proofmass
