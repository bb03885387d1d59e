// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/far_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "proofmass/assess/diagnosis/fit/robust_residuals.hpp"
#include "proofmass/assess/diagnosis/record/term_space.hpp"
#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/linear/rank_analysis.hpp"
#include "proofmass/numeric/regression/robust_loss.hpp"

namespace proofmass {
namespace {

// Standard errors, or robust scales: the noise of rows may differ by a factor of ten.
constexpr double kFarRow = 15.0;
constexpr double kUnlikelyRow = 1e-6;  // of the farthest row of a record
constexpr double kMasked = 8.0;   // robust scales, that the residuals' deviation is at least: few rows beside
                                  // the terms make the robust scale too small
constexpr double kTrimmed = 3.5;  // robust scales, beyond which a row does not count for a trimmed fit
constexpr double kWorthATrim = 0.01;  // of the rows, beyond that: ten times what normal noise has
constexpr int kTrims = 6;
constexpr double kSettled = 0.9;  // of the scale before
constexpr int kMostPasses = 20;
constexpr double kDivided = 15.0;  // deviations of what two groups leave, that the residuals' is at least:
                                   // normal noise divided into two has 1.7
constexpr double kWorthDividing = 3.5;  // in squares: normal noise divided by its sign leaves 2.75 times less
constexpr std::size_t kRowsPerTermDivided = 3;
constexpr std::size_t kLeastGroup = 4;
constexpr double kFewDof = 30.0;
constexpr double kLeastVariance =
    1e-9;  // of a row's own variance: below it the row is fitted whatever its output

// One residual a row, as if all had one variance.
struct AlikeResiduals {
  std::vector<double> residuals;
  std::vector<double> values;
  double scale = 0.0;
  [[nodiscard]] double deviation() const {
    return std::sqrt(sum_of_squares(values) / static_cast<double>(values.size()));
  }
};

// What the fit leaves of the variance of each row's noise, and that variance, relative to one another.
struct RowNoise {
  std::vector<double> left;
  std::vector<double> variance;
};

// By the method's weights, with the leverages of a fit by them.
RowNoise noise_by_weights(const FittedRows& rows) {
  Matrix design = rows.basis();
  const std::vector<double> response(rows.rows(), 0.0);
  RowNoise noise{.left = std::vector<double>(rows.rows(), 0.0), .variance = {}};
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    noise.variance.push_back(1.0 / std::max(rows.weights()[row], std::numeric_limits<double>::min()));
    for (std::size_t c = 0; c < design.columns(); ++c) design(row, c) *= std::sqrt(rows.weights()[row]);
  }
  if (design.columns() == 0 || analyse_rank(design).rank < design.columns()) return noise;
  const std::vector<double> leverage = solve_least_squares(design, response).leverage;
  for (std::size_t row = 0; row < rows.rows(); ++row)
    noise.left[row] = (1.0 - leverage[row]) * noise.variance[row];
  return noise;
}

// By the record's uncertainties, with the noise that other rows put into a residual.
RowNoise noise_by_sigma(const FittedRows& rows) {
  const std::vector<double>& sigma = rows.record().output_sigma;
  const std::size_t columns = rows.basis().columns();
  Matrix products(columns, columns);
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    for (std::size_t a = 0; a < columns; ++a) {
      for (std::size_t b = 0; b < columns; ++b)
        products(a, b) += rows.basis()(row, a) * rows.basis()(row, b) * sigma[row] * sigma[row];
    }
  }
  RowNoise noise;
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    noise.variance.push_back(sigma[row] * sigma[row]);
    double left = noise.variance.back() * (1.0 - 2.0 * rows.leverages()[row]);
    for (std::size_t a = 0; a < columns; ++a) {
      for (std::size_t b = 0; b < columns; ++b)
        left += rows.basis()(row, a) * products(a, b) * rows.basis()(row, b);
    }
    noise.left.push_back(left);
  }
  return noise;
}

RowNoise noise_of(const FittedRows& rows) {
  if (!rows.weights().empty()) return noise_by_weights(rows);
  if (!rows.record().output_sigma.empty()) return noise_by_sigma(rows);
  RowNoise noise{.left = {}, .variance = std::vector<double>(rows.rows(), 1.0)};
  for (const double leverage : rows.leverages()) noise.left.push_back(1.0 - leverage);
  return noise;
}

// Residuals as if all had one variance.
AlikeResiduals alike_residuals(const FittedRows& rows, const RowNoise& noise, std::vector<double> residuals) {
  AlikeResiduals alike{.residuals = std::move(residuals), .values = std::vector<double>(rows.rows(), 0.0)};
  for (std::size_t row = 0; row < alike.values.size(); ++row) {
    if (noise.left[row] > kLeastVariance * noise.variance[row])
      alike.values[row] = alike.residuals[row] / std::sqrt(noise.left[row]);
  }
  // Where all rows have one variance, no less than rounding leaves.
  const bool one_variance = rows.weights().empty() && rows.record().output_sigma.empty();
  alike.scale =
      std::max(median_scale(alike.values, rows.basis().columns()), one_variance ? rows.rounding() : 0.0);
  return alike;
}

// The residuals of all rows from a fit to those that lie near it.
std::vector<double> residuals_from_near(const FittedRows& rows, const AlikeResiduals& alike) {
  std::vector<double> weights(rows.rows(), 0.0);
  std::size_t near = 0;
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    if (std::abs(alike.values[row]) > kTrimmed * alike.scale) continue;
    weights[row] = rows.weights().empty() ? 1.0 : rows.weights()[row];
    ++near;
  }
  if (near == rows.rows() || near < 2 * rows.basis().columns())
    return {rows.residuals().begin(), rows.residuals().end()};
  return rows.residuals_by(weights);
}

// As a fit has them that outlying rows do not move: where some lie off, they spread over the residuals of all
// others and hide each other.
AlikeResiduals without_outliers(const FittedRows& rows, const RowNoise& noise, AlikeResiduals alike) {
  for (int trim = 0; trim < kTrims; ++trim) {
    const auto off = std::count_if(alike.values.begin(), alike.values.end(),
                                   [&alike](double r) { return std::abs(r) > kTrimmed * alike.scale; });
    if (static_cast<double>(off) < kWorthATrim * static_cast<double>(rows.rows())) break;
    AlikeResiduals next = alike_residuals(rows, noise, residuals_from_near(rows, alike));
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

std::vector<std::size_t> far_rows_of(const FittedRows& rows, const RowNoise& noise, const AlikeResiduals& own,
                                     const AlikeResiduals& robust) {
  double squares = 0.0;
  for (std::size_t row = 0; row < own.values.size(); ++row)
    squares += own.values[row] * own.values[row] * noise.left[row] / noise.variance[row];
  // The scale of few rows is uncertain, the more so when the farthest of them are left out of it.
  const double limit = kFarRow * (1.0 + kFewDof / static_cast<double>(rows.dof()));
  std::vector<std::size_t> far;
  for (std::size_t row = 0; row < own.values.size(); ++row) {
    const bool beyond = std::abs(robust.values[row]) > limit * robust.scale;
    if (beyond || is_far_alone(own.values[row], squares, rows)) far.push_back(row);
  }
  return far;
}

// Where rows differ in their noise, the scale is that of the farthest row: what it is tested by.
double scale_of(const FittedRows& rows, const RowNoise& noise, const AlikeResiduals& robust,
                std::size_t row) {
  const bool one_variance = rows.weights().empty() && rows.record().output_sigma.empty();
  return one_variance ? std::min(robust.scale, rows.scale()) : robust.scale * std::sqrt(noise.left[row]);
}

Finding finding_of(const FittedRows& rows, const RowNoise& noise, const std::vector<std::size_t>& far,
                   const AlikeResiduals& robust) {
  const std::size_t farthest = *std::max_element(far.begin(), far.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(robust.values[a]) < std::abs(robust.values[b]);
  });
  const double scale = scale_of(rows, noise, robust, farthest);
  const Unit& unit = rows.record().output_unit;
  return {.code = Code::rows_far_off,
          .severity = Severity::warning,
          .lines = rows.record().lines_of(far),
          .figures = {{"count", far.size()},
                      {"line", rows.record().line_of(farthest)},
                      {"residual", robust.residuals[farthest] / unit.to_canonical},
                      {"scale", scale / std::abs(unit.to_canonical)},
                      {"unit", unit.symbol}}};
}

// As a robust fit has them, where the rows far off are so many that they hide each other in any other.
std::optional<AlikeResiduals> without_masking(const FittedRows& rows, const RowNoise& noise,
                                              const AlikeResiduals& own) {
  auto left = robust_residuals(rows);
  if (!left) return std::nullopt;
  AlikeResiduals robust = alike_residuals(rows, noise, std::move(*left));
  if (own.deviation() < kMasked * robust.scale) return std::nullopt;
  return robust;
}

// Two groups of rows, one of which has more of a shape (one, or Ai) than the other: nearly half of the rows
// are too many for a robust fit.
struct TwoGroups {
  std::vector<bool> second;
  double more = 0.0;  // of the shape, in the second
  std::vector<double> left;
};

// The slope along the shape in the second group, and what it leaves of the residuals.
void fit_second(const FittedRows& rows, const std::vector<double>& shape, TwoGroups& groups) {
  std::vector<double> column(rows.rows(), 0.0);
  for (std::size_t row = 0; row < column.size(); ++row) column[row] = groups.second[row] ? shape[row] : 0.0;
  column = rows.beyond_terms(std::move(column));
  const double size = sum_of_squares(column);
  groups.more = size > 0.0 ? dot(column, rows.residuals()) / size : 0.0;
  groups.left.assign(rows.residuals().begin(), rows.residuals().end());
  for (std::size_t row = 0; row < column.size(); ++row) groups.left[row] -= groups.more * column[row];
}

// Rows go to the group that they are closer to, until none changes (Lloyd, IEEE Trans. Inf. Theory 28, 1982),
// from those that lie above the fit, as the shape has it.
TwoGroups divide_rows(const FittedRows& rows, const std::vector<double>& shape) {
  TwoGroups groups{.second = std::vector<bool>(rows.rows(), false), .left = {}};
  for (std::size_t row = 0; row < rows.rows(); ++row)
    groups.second[row] = rows.residuals()[row] * shape[row] > 0.0;
  const double before = sum_of_squares(rows.residuals());
  for (int pass = 0; pass < kMostPasses; ++pass) {
    fit_second(rows, shape, groups);
    if (pass == 0 && sum_of_squares(groups.left) * kWorthDividing > before) break;
    bool changed = false;
    for (std::size_t row = 0; row < rows.rows(); ++row) {
      const double own = groups.left[row];
      const double other = own + (groups.second[row] ? groups.more : -groups.more) * shape[row];
      if (std::abs(other) >= std::abs(own)) continue;
      groups.second[row] = !groups.second[row];
      changed = true;
    }
    if (!changed) break;
  }
  fit_second(rows, shape, groups);
  return groups;
}

// The rows of the smaller group, where the two are told apart far beyond what noise does.
std::optional<Finding> of_other_instrument(const FittedRows& rows, const RowNoise& noise,
                                           const AlikeResiduals& own) {
  if (rows.rows() < kRowsPerTermDivided * (rows.basis().columns() + 1)) return std::nullopt;
  std::vector<std::vector<double>> shapes{std::vector<double>(rows.rows(), 1.0)};
  if (rows.record().has(Axis::input)) shapes.push_back(rows.record().along(Axis::input));
  for (const std::vector<double>& shape : shapes) {
    const TwoGroups groups = divide_rows(rows, shape);
    const AlikeResiduals divided = alike_residuals(rows, noise, groups.left);
    if (own.deviation() < kDivided * divided.deviation()) continue;
    const auto count = std::count(groups.second.begin(), groups.second.end(), true);
    const bool second = 2 * static_cast<std::size_t>(count) <= rows.rows();
    AlikeResiduals others = divided;
    std::vector<std::size_t> far;
    for (std::size_t row = 0; row < rows.rows(); ++row) {
      if (groups.second[row] != second || noise.left[row] <= kLeastVariance * noise.variance[row]) continue;
      others.residuals[row] += (second ? groups.more : -groups.more) * shape[row];
      others.values[row] = others.residuals[row] / std::sqrt(noise.left[row]);
      if (std::abs(others.values[row]) > kFarRow * divided.scale) far.push_back(row);
    }
    if (far.size() >= kLeastGroup) return finding_of(rows, noise, far, others);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Finding> find_far_rows(const FittedRows& rows, const Identification& result, bool masked_too) {
  if (std::holds_alternative<RobustDetails>(result.details)) return std::nullopt;
  const RowNoise noise = noise_of(rows);
  const AlikeResiduals own = alike_residuals(rows, noise, {rows.residuals().begin(), rows.residuals().end()});
  const AlikeResiduals trimmed = without_outliers(rows, noise, own);
  const std::vector<std::size_t> far = far_rows_of(rows, noise, own, trimmed);
  // Of many that are alike some may lie far enough to be seen alone.
  auto group = masked_too ? of_other_instrument(rows, noise, own) : std::nullopt;
  if (group && group->lines.size() > far.size()) return group;
  if (!far.empty()) return finding_of(rows, noise, far, trimmed);
  const auto robust = masked_too ? without_masking(rows, noise, own) : std::nullopt;
  if (!robust) return std::nullopt;
  const std::vector<std::size_t> masked = far_rows_of(rows, noise, *robust, *robust);
  return masked.empty() ? std::nullopt : std::optional(finding_of(rows, noise, masked, *robust));
}

}  // namespace proofmass
