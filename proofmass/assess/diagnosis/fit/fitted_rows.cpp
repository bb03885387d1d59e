// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "proofmass/assess/diagnosis/record/output_resolution.hpp"
#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/term_sums.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"
#include "proofmass/numeric/regression/robust_loss.hpp"

namespace proofmass {
namespace {

constexpr double kBound = 2.5;                // of bounded residuals
constexpr double kRounding = 1e-12;           // of the largest output
constexpr double kRoundingOfStep = 0.5;       // of the output's step; rounding alone has 0.29
constexpr double kRoundingOfLeverage = 1e-9;  // below it a row is fitted whatever its output
constexpr std::size_t kLeastDof = 8;

TermList identified_terms(const Identification& result) {
  TermList terms;
  for (const Coefficient& c : result.coefficients) {
    if (c.identified) terms.push_back(c.term);
  }
  return terms;
}

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// The size below which residuals are the rounding of arithmetic or of the outputs.
double rounding_of(const Dataset& record) {
  if (record.rows() == 0) return 0.0;
  double largest = 0.0;
  for (const double e : record.output) largest = std::max(largest, std::abs(e));
  return std::max(kRounding * largest, kRoundingOfStep * output_resolution(record).step);
}

std::vector<std::size_t> some_of(std::span<const std::size_t> training) {
  std::vector<std::size_t> rows = thinned_rows(training.size());
  for (std::size_t& row : rows) row = training[row];
  return rows;
}

}  // namespace

Matrix orthonormal_rows(const Dataset& rows, const TermList& asked) {
  const TermSums sums(rows, asked);
  const TermList terms = analyse_identifiability(sums, asked).identified;
  Matrix basis(rows.rows(), terms.size());
  if (terms.empty() || rows.rows() < terms.size()) return Matrix(rows.rows(), 0);
  const TermRows regressors = sums.rows(terms);
  const Matrix orthogonaliser = solve_normal_equations(sums.gram(terms), regressors).orthogonaliser;
  RowBlock block(terms.size() + 1);
  for (std::size_t first = 0; first < rows.rows(); first += RowBlock::kRows) {
    const std::size_t count = std::min(RowBlock::kRows, rows.rows() - first);
    regressors.fill(first, count, block);
    for (std::size_t c = 0; c < terms.size(); ++c) {
      double* const column = basis.column(c).data() + first;
      for (std::size_t k = 0; k <= c; ++k) {
        const double factor = orthogonaliser(k, c);
        const double* const values = block.column(k);
        for (std::size_t r = 0; r < count; ++r) column[r] += factor * values[r];
      }
    }
  }
  return basis;
}

double student_probability(double t, double dof) {
  if (!(dof > 0.0)) return 1.0;
  if (!std::isfinite(t)) return std::isnan(t) ? 1.0 : 0.0;
  return 2.0 * boost::math::cdf(
                   boost::math::complement(boost::math::students_t_distribution<double>(dof), std::abs(t)));
}

FittedRows::FittedRows(const Dataset& record, std::span<const std::size_t> training,
                       const Identification& result)
    : record_(record.select(some_of(training))),
      residuals_(record_.output),
      basis_(orthonormal_rows(record_, identified_terms(result))) {
  leverages_.assign(residuals_.size(), 0.0);
  for (std::size_t c = 0; c < basis_.columns(); ++c) {
    const std::span<const double> column = basis_.column(c);
    for (std::size_t row = 0; row < column.size(); ++row) leverages_[row] += column[row] * column[row];
  }
  const std::vector<double> predicted = predict(result, record_);
  for (std::size_t row = 0; row < residuals_.size(); ++row) residuals_[row] -= predicted[row];
  dof_ = residuals_.size() - std::min(residuals_.size(), basis_.columns());
  scale_ = median_scale(residuals_, basis_.columns());
  has_noise_ = dof_ >= kLeastDof && scale_ > rounding_of(record_);
  if (!(scale_ > 0.0)) return;
  for (const double r : residuals_) bounded_.push_back(std::clamp(r / scale_, -kBound, kBound));
  if (dof_ > 0) bounded_variance_ = sum_of_squares(bounded_) / static_cast<double>(dof_);
}

std::vector<double> beyond_columns(const Matrix& basis, std::vector<double> values) {
  for (std::size_t c = 0; c < basis.columns(); ++c) {
    const std::span<const double> column = basis.column(c);
    const double along = dot(column, values);
    for (std::size_t row = 0; row < values.size(); ++row) values[row] -= along * column[row];
  }
  return values;
}

double sum_of_squares(std::span<const double> values) { return dot(values, values); }

std::vector<double> FittedRows::beyond_terms(std::vector<double> values) const {
  return beyond_columns(basis_, std::move(values));
}

Departure FittedRows::departure(std::span<const double> weights) const {
  const double size = sum_of_squares(weights);
  const double alike = dot(weights, bounded_) / std::sqrt(size * bounded_variance_);
  const double slope = dot(weights, residuals_) / size;
  double squares = 0.0;
  for (std::size_t row = 0; row < weights.size(); ++row) {
    const double w = weights[row];
    const double left = 1.0 - leverages_[row] - w * w / size;
    const double product = w * (residuals_[row] - slope * w) / left;
    squares += left > kRoundingOfLeverage ? product * product : 0.0;
  }
  const double different = slope * size / std::sqrt(squares);
  if (!(std::isfinite(alike) && std::isfinite(different)) || alike * different < 0.0) return {};
  const double least = std::abs(alike) < std::abs(different) ? alike : different;
  return {.errors = different, .probability = student_probability(least, static_cast<double>(dof_))};
}

}  // namespace proofmass
