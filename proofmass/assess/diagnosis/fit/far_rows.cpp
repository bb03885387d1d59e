// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/far_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/linear/rank_analysis.hpp"
#include "proofmass/numeric/regression/robust_loss.hpp"

namespace proofmass {
namespace {

// Standard errors, or robust scales: the noise of rows may differ by a factor of ten.
constexpr double kFarRow = 15.0;
constexpr double kUnlikelyRow = 1e-6;  // of the farthest row of a record
constexpr double kTrimmed = 3.5;       // robust scales, beyond which a row does not count for a trimmed fit
constexpr double kWorthATrim = 0.01;   // of the rows, beyond that: ten times what normal noise has
constexpr int kTrims = 6;
constexpr double kSettled = 0.9;  // of the scale before
constexpr std::size_t kLeastDofOfScale = 30;
constexpr double kLeastVariance =
    1e-9;  // of the largest variance: below it a row is fitted whatever its output

// One residual a row, as if all had one variance.
struct AlikeResiduals {
  std::vector<double> values;
  double scale = 0.0;
};

// The variance of each residual, relative to one another: what the fit leaves of the row's own noise, by the
// method's weights, or by the record's uncertainties and then with the noise that other rows put into it.
std::vector<double> variances_of(const FittedRows& rows) {
  std::vector<double> variance(rows.rows());
  const std::vector<double>& sigma = rows.record().output_sigma;
  const bool known = rows.weights().empty() && !sigma.empty();
  const std::size_t columns = rows.basis().columns();
  Matrix noise(columns, columns);  // of the coefficients of the basis
  for (std::size_t row = 0; known && row < rows.rows(); ++row) {
    for (std::size_t a = 0; a < columns; ++a) {
      for (std::size_t b = 0; b < columns; ++b)
        noise(a, b) += rows.basis()(row, a) * rows.basis()(row, b) * sigma[row] * sigma[row];
    }
  }
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    const double leverage = rows.leverages()[row];
    variance[row] = (1.0 - leverage) / (rows.weights().empty() ? 1.0 : rows.weights()[row]);
    if (!known) continue;
    variance[row] = sigma[row] * sigma[row] * (1.0 - 2.0 * leverage);
    for (std::size_t a = 0; a < columns; ++a) {
      for (std::size_t b = 0; b < columns; ++b)
        variance[row] += rows.basis()(row, a) * noise(a, b) * rows.basis()(row, b);
    }
  }
  return variance;
}

// Residuals as if all had one variance.
AlikeResiduals alike_residuals(const FittedRows& rows, const std::vector<double>& residuals) {
  AlikeResiduals alike{.values = std::vector<double>(rows.rows(), 0.0)};
  const std::vector<double> variance = variances_of(rows);
  const double least = kLeastVariance * *std::max_element(variance.begin(), variance.end());
  for (std::size_t row = 0; row < alike.values.size(); ++row) {
    if (variance[row] > least) alike.values[row] = residuals[row] / std::sqrt(variance[row]);
  }
  alike.scale = median_scale(alike.values, rows.basis().columns());
  return alike;
}

// The residuals of all rows from a fit to those that lie near it.
std::vector<double> residuals_from_near(const FittedRows& rows, const AlikeResiduals& alike) {
  std::vector<std::size_t> near;
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    if (std::abs(alike.values[row]) <= kTrimmed * alike.scale) near.push_back(row);
  }
  std::vector<double> residuals(rows.residuals().begin(), rows.residuals().end());
  const std::size_t columns = rows.basis().columns();
  if (near.size() == rows.rows() || near.size() < 2 * columns || columns == 0) return residuals;
  Matrix design(near.size(), columns);
  std::vector<double> response;
  for (const std::size_t row : near) {
    for (std::size_t c = 0; c < columns; ++c) design(response.size(), c) = rows.basis()(row, c);
    response.push_back(residuals[row]);
  }
  if (analyse_rank(design).rank < columns) return residuals;
  const std::vector<double> moved = solve_least_squares(design, response).coefficients;
  for (std::size_t row = 0; row < residuals.size(); ++row) {
    for (std::size_t c = 0; c < columns; ++c) residuals[row] -= rows.basis()(row, c) * moved[c];
  }
  return residuals;
}

// As a fit has them that outlying rows do not move: where some lie off, they spread over the residuals of all
// others and hide each other.
AlikeResiduals without_outliers(const FittedRows& rows, AlikeResiduals alike) {
  for (int trim = 0; trim < kTrims; ++trim) {
    const auto off = std::count_if(alike.values.begin(), alike.values.end(),
                                   [&alike](double r) { return std::abs(r) > kTrimmed * alike.scale; });
    if (static_cast<double>(off) < kWorthATrim * static_cast<double>(rows.rows())) break;
    AlikeResiduals next = alike_residuals(rows, residuals_from_near(rows, alike));
    const bool settled = next.scale > kSettled * alike.scale;
    alike = std::move(next);
    if (settled) break;
  }
  return alike;
}

// Of one row, by the standard deviation of what a fit without it leaves of the others (externally
// studentised: Cook and Weisberg, Residuals and Influence in Regression, 1982, 2.2.1).
double errors_without(double alike, double squares, double dof) {
  const double others = squares - alike * alike;
  return others > 0.0 ? std::abs(alike) * std::sqrt((dof - 1.0) / others)
                      : std::numeric_limits<double>::infinity();
}

bool is_far_alone(double alike, double squares, const FittedRows& rows) {
  const double dof = static_cast<double>(rows.dof());
  const double errors = errors_without(alike, squares, dof);
  return errors > kFarRow &&
         student_probability(errors, dof - 1.0) * static_cast<double>(rows.rows()) < kUnlikelyRow;
}

}  // namespace

std::optional<Finding> find_far_rows(const FittedRows& rows, const Identification& result) {
  if (std::holds_alternative<RobustDetails>(result.details)) return std::nullopt;
  const AlikeResiduals own = alike_residuals(rows, {rows.residuals().begin(), rows.residuals().end()});
  const std::vector<double>& alike = own.values;
  const AlikeResiduals robust = without_outliers(rows, own);
  double squares = 0.0;
  for (std::size_t row = 0; row < alike.size(); ++row)
    squares += alike[row] * alike[row] * (1.0 - rows.leverages()[row]);
  std::vector<std::size_t> far;
  std::size_t farthest = 0;
  for (std::size_t row = 0; row < alike.size(); ++row) {
    if (std::abs(alike[row]) > std::abs(alike[farthest])) farthest = row;
    const bool beyond =
        rows.dof() >= kLeastDofOfScale && std::abs(robust.values[row]) > kFarRow * robust.scale;
    if (beyond || is_far_alone(alike[row], squares, rows)) far.push_back(row);
  }
  if (far.empty()) return std::nullopt;
  const double scale = rows.weights().empty() ? std::min(robust.scale, rows.scale()) : rows.scale();
  const Unit& unit = rows.record().output_unit;
  return Finding{.code = Code::rows_far_off,
                 .severity = Severity::warning,
                 .lines = rows.record().lines_of(far),
                 .figures = {{"count", far.size()},
                             {"line", rows.record().line_of(farthest)},
                             {"residual", rows.residuals()[farthest] / unit.to_canonical},
                             {"scale", scale / std::abs(unit.to_canonical)},
                             {"unit", unit.symbol}}};
}

}  // namespace proofmass
