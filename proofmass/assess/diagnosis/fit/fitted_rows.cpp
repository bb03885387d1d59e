// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "proofmass/assess/diagnosis/record/output_resolution.hpp"
#include "proofmass/assess/diagnosis/record/term_space.hpp"
#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/linear/rank_analysis.hpp"
#include "proofmass/numeric/regression/robust_loss.hpp"

namespace proofmass {
namespace {

constexpr double kBound = 2.5;           // of bounded residuals
constexpr double kRounding = 1e-12;      // of the largest output
constexpr double kRoundingOfStep = 0.5;  // of the step of outputs or inputs; rounding alone has 0.29
constexpr double kLeastOfInputStep = 0.15;
constexpr double kRoundingOfLeverage = 1e-9;  // below it a row is fitted whatever its output
constexpr std::size_t kLeastDof = 8;
constexpr double kPlausible = 1e-3;  // probability above which no test here finds anything
constexpr int kMostSteps = 30;
constexpr double kSmallStep = 1e-3;  // of the standard error

TermList identified_terms(const Identification& result) {
  TermList terms;
  for (const Coefficient& c : result.coefficients) {
    if (c.identified) terms.push_back(c.term);
  }
  return terms;
}

// The size below which residuals are the rounding of arithmetic or of the outputs.
double rounding_of(const Dataset& record) {
  if (record.rows() == 0) return 0.0;
  double largest = 0.0;
  for (const double e : record.output) largest = std::max(largest, std::abs(e));
  return std::max(kRounding * largest, kRoundingOfStep * output_resolution(record).step);
}

// The step in which Ai is written, in the output's canonical unit.
double input_step_of(const Dataset& record, const Identification& result) {
  for (const Coefficient& c : result.coefficients) {
    if (c.term == Term::Ki && c.identified)
      return std::abs(c.value) * record.acceleration_resolution[static_cast<std::size_t>(Axis::input)];
  }
  return 0.0;
}

std::vector<std::size_t> some_of(std::span<const std::size_t> training) {
  std::vector<std::size_t> rows = thinned_rows(training.size());
  for (std::size_t& row : rows) row = training[row];
  return rows;
}

}  // namespace

double student_probability(double t, double dof) {
  if (!(dof > 0.0)) return 1.0;
  if (!std::isfinite(t)) return std::isnan(t) ? 1.0 : 0.0;
  return 2.0 * boost::math::cdf(
                   boost::math::complement(boost::math::students_t_distribution<double>(dof), std::abs(t)));
}

double fisher_probability(double ratio, double numerator, double denominator) {
  if (std::isnan(ratio) || !(denominator >= 1.0)) return 1.0;
  if (std::isinf(ratio)) return 0.0;
  return boost::math::cdf(
      boost::math::complement(boost::math::fisher_f_distribution<double>(numerator, denominator), ratio));
}

FittedRows::FittedRows(const Dataset& record, std::span<const std::size_t> training,
                       const Identification& result, bool inputs_uncertain)
    : record_(record.select(some_of(training))),
      residuals_(record_.output),
      basis_(orthonormal_rows(record_, identified_terms(result))),
      rounding_(rounding_of(record_)),
      input_step_(input_step_of(record_, result)),
      inputs_uncertain_(inputs_uncertain) {
  const std::vector<double>& weights = result.row_weights.values;
  for (const std::size_t row : thinned_rows(weights.size())) weights_.push_back(weights[row]);
  if (weights_.size() != residuals_.size()) weights_.clear();
  const std::vector<double> predicted = predict(result, record_);
  for (std::size_t row = 0; row < residuals_.size(); ++row) residuals_[row] -= predicted[row];
  take_leverages();
}

void FittedRows::take_leverages() {
  leverages_.assign(residuals_.size(), 0.0);
  for (std::size_t c = 0; c < basis_.columns(); ++c) {
    const std::span<const double> column = basis_.column(c);
    for (std::size_t row = 0; row < column.size(); ++row) leverages_[row] += column[row] * column[row];
  }
  dof_ = residuals_.size() - std::min(residuals_.size(), basis_.columns());
  scale_ = median_scale(residuals_, basis_.columns());
  // Nominal inputs in round numbers have coarse steps and no rounding; then residuals are far below it.
  const bool inputs_rounded =
      scale_ > kLeastOfInputStep * input_step_ && scale_ < kRoundingOfStep * input_step_;
  has_noise_ = dof_ >= kLeastDof && scale_ > rounding_ && !inputs_rounded;
}

std::vector<double> FittedRows::residuals_by(std::span<const double> weights) const {
  Matrix design = basis_;
  std::vector<double> response(residuals_);
  for (std::size_t row = 0; row < rows(); ++row) {
    const double root = std::sqrt(weights[row]);
    response[row] *= root;
    for (std::size_t c = 0; c < design.columns(); ++c) design(row, c) *= root;
  }
  if (design.columns() == 0 || analyse_rank(design).rank < design.columns()) return residuals_;
  const std::vector<double> moved = solve_least_squares(design, response).coefficients;
  std::vector<double> left(residuals_);
  for (std::size_t row = 0; row < rows(); ++row) {
    for (std::size_t c = 0; c < moved.size(); ++c) left[row] -= basis_(row, c) * moved[c];
  }
  return left;
}

FittedRows FittedRows::with_columns(const Matrix& columns) const {
  FittedRows more = *this;
  more.basis_ = Matrix(rows(), basis_.columns() + columns.columns());
  for (std::size_t c = 0; c < more.basis_.columns(); ++c) {
    const std::span<const double> from =
        c < basis_.columns() ? basis_.column(c) : columns.column(c - basis_.columns());
    std::copy(from.begin(), from.end(), more.basis_.column(c).begin());
  }
  more.residuals_ = beyond_columns(columns, residuals_);
  more.take_leverages();
  return more;
}

double FittedRows::standard_deviation() const {
  return std::sqrt(sum_of_squares(residuals_) / static_cast<double>(std::max<std::size_t>(1, dof_)));
}

std::vector<double> FittedRows::beyond_terms(std::vector<double> values) const {
  return beyond_columns(basis_, std::move(values));
}

std::vector<std::vector<double>> regressor_columns(const Dataset& rows, const TermList& terms) {
  std::vector<std::vector<double>> columns;
  columns.reserve(terms.size());
  for (const Term term : terms) {
    std::vector<double>& values = columns.emplace_back(rows.rows());
    for (std::size_t row = 0; row < values.size(); ++row) values[row] = regressor(term, rows.at(row));
  }
  return columns;
}

std::vector<double> bounded(std::span<const double> residuals, double scale) {
  std::vector<double> held(residuals.begin(), residuals.end());
  for (double& r : held) r = std::clamp(r / scale, -kBound, kBound);
  return held;
}

// Newton steps of the slope of bounded residuals, their scale taken anew each time from what the slope
// leaves; a trend that is larger than the noise is then no part of the scale that it is judged by.
double FittedRows::bounded_errors(std::span<const double> weights, double size) const {
  const std::size_t fitted = basis_.columns() + 1;
  const auto left = static_cast<double>(rows()) - static_cast<double>(fitted);
  std::vector<double> rest(residuals_);
  double slope = 0.0;
  double error = 0.0;
  for (int step = 0; step < kMostSteps; ++step) {
    const double scale = std::max(median_scale(rest, fitted), rounding_);
    if (!(scale > 0.0)) return slope == 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
    const std::vector<double> held = bounded(rest, scale);
    const auto within = static_cast<double>(
        std::count_if(held.begin(), held.end(), [](double r) { return std::abs(r) < kBound; }));
    const double curvature = std::max(within / static_cast<double>(rows()), 0.5);
    const double change = scale * dot(weights, held) / (size * curvature);
    slope += change;
    error = scale * std::sqrt(sum_of_squares(held) / (left * size)) / curvature;
    if (std::abs(change) < kSmallStep * error) break;
    for (std::size_t row = 0; row < rest.size(); ++row) rest[row] = residuals_[row] - slope * weights[row];
  }
  return slope / error;
}

Departure FittedRows::departure(std::span<const double> weights) const {
  const double size = sum_of_squares(weights);
  const double slope = dot(weights, residuals_) / size;
  double squares = 0.0;
  for (std::size_t row = 0; row < weights.size(); ++row) {
    const double w = weights[row];
    const double left = 1.0 - leverages_[row] - w * w / size;
    const double rest = std::max(std::abs(residuals_[row] - slope * w), rounding_);
    const double product = left > kRoundingOfLeverage ? w * rest / left : 0.0;
    squares += product * product;
  }
  const double different = slope * size / std::sqrt(squares);
  const double dof = static_cast<double>(dof_) - 1.0;
  const double probability = student_probability(different, dof);
  if (!std::isfinite(different)) return {};
  if (probability > kPlausible) return {.errors = different, .probability = probability};
  const double alike = bounded_errors(weights, size);
  if (!(alike * different > 0.0)) return {.errors = different, .probability = 1.0};
  return {.errors = different, .probability = std::max(probability, student_probability(alike, dof))};
}

}  // namespace proofmass
