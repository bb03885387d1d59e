// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/serial_correlation.hpp"

#include <cmath>
#include <cstddef>
#include <string>

#include "proofmass/assess/diagnosis/record/term_space.hpp"

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

bool starts_mount(const Dataset& record, std::size_t row) {
  return !record.mount.empty() && record.mount[row] != record.mount[row - 1];
}

// Products of neighbours that belong to different mounts.
struct Products {
  std::size_t count = 0;
  double sum = 0.0;
  double squares = 0.0;
  void add(double product) {
    ++count;
    sum += product;
    squares += product * product;
  }
  // Whether enough of them show that residuals are alike within mounts only.
  [[nodiscard]] bool show_nothing() const {
    constexpr std::size_t kEnough = 10;
    constexpr double kNothing = 2.0;
    return count >= kEnough && sum < kNothing * std::sqrt(squares);
  }
};

}  // namespace

std::optional<Finding> find_serial_correlation(const FittedRows& rows) {
  if (rows.dof() < kLeastCorrelationDof) return std::nullopt;
  const std::vector<double> r = bounded(rows.residuals(), rows.scale());
  const double variance = sum_of_squares(r) / static_cast<double>(rows.dof());
  double sum = 0.0;
  double squares = 0.0;
  Products across;
  for (std::size_t row = 1; row < r.size(); ++row) {
    const double product = r[row - 1] * r[row];
    sum += product;
    squares += product * product;
    if (starts_mount(rows.record(), row)) across.add(product);
  }
  sum -= variance * made_by_fit(rows.basis());
  if (!(sum > kUnlikelyCorrelation * std::sqrt(squares))) return std::nullopt;
  const double correlation = sum / (variance * static_cast<double>(r.size() - 1));
  return Finding{.code = Code::residuals_correlated,
                 .severity = Severity::warning,
                 .figures = {{"correlation", correlation},
                             {"errors", sum / std::sqrt(squares)},
                             {"within", std::string(across.show_nothing() ? "mounts" : "rows")}}};
}

}  // namespace proofmass
