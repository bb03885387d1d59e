// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// How far something lies from zero by chance alone.
struct Departure {
  double errors = 0.0;       // in its own standard errors, with its sign
  double probability = 1.0;  // of one as large or larger, of either sign
};

// The rows that a fit was made from, at most kMostDiagnosedRows of them, what it leaves of their outputs, and
// the space of its terms over them.
class FittedRows {
 public:
  // `inputs_uncertain`: whether the method takes the inputs for uncertain.
  FittedRows(const Dataset& record, std::span<const std::size_t> training, const Identification& result,
             bool inputs_uncertain);

  [[nodiscard]] const Dataset& record() const noexcept { return record_; }
  // Where it is none: nothing is then sought along it.
  void leave_out_temperature() { record_.temperature.clear(); }
  [[nodiscard]] std::span<const double> residuals() const noexcept { return residuals_; }
  [[nodiscard]] std::size_t rows() const noexcept { return residuals_.size(); }
  [[nodiscard]] std::size_t dof() const noexcept { return dof_; }
  [[nodiscard]] double scale() const noexcept { return scale_; }  // robust, of the residuals
  [[nodiscard]] double standard_deviation() const;                // of the residuals, by dof()
  // Below it residuals are the rounding of arithmetic or of the outputs.
  [[nodiscard]] double rounding() const noexcept { return rounding_; }
  // Whether the residuals are more than rounding, of the inputs too, and enough to show a pattern.
  [[nodiscard]] bool has_noise() const noexcept { return has_noise_; }
  // Rows whose columns are orthonormal and span the terms of the fit: rows() x terms.
  [[nodiscard]] const Matrix& basis() const noexcept { return basis_; }
  [[nodiscard]] bool inputs_uncertain() const noexcept { return inputs_uncertain_; }
  // One a row, of the method's noise model: the larger the less noise; empty where all rows count alike.
  [[nodiscard]] std::span<const double> weights() const noexcept { return weights_; }
  // Of the terms of the fit, one a row: the diagonal of the hat matrix.
  [[nodiscard]] std::span<const double> leverages() const noexcept { return leverages_; }

  // What of the values, one a row, no combination of the terms of the fit gives.
  [[nodiscard]] std::vector<double> beyond_terms(std::vector<double> values) const;
  // How far the slope of the residuals along `weights`, which are beyond the terms, lies from zero, by
  // standard errors for noise that differs from row to row (HC3: MacKinnon and White, J. Econometrics 29,
  // 1985). The probability is the larger of that and of the slope that bounded residuals give, on which
  // outliers have little effect (Huber, Ann. Math. Statist. 35, 1964).
  [[nodiscard]] Departure departure(std::span<const double> weights) const;
  // What a fit of the terms with these weights, one a row, leaves of all rows; the residuals as they are
  // where the weighted rows do not tell the terms.
  [[nodiscard]] std::vector<double> residuals_by(std::span<const double> weights) const;
  // The same rows as if these orthonormal columns, which are beyond the terms, had been fitted too.
  [[nodiscard]] FittedRows with_columns(const Matrix& columns) const;

 private:
  [[nodiscard]] double bounded_errors(std::span<const double> weights, double size) const;
  void take_leverages();

  Dataset record_;
  std::vector<double> residuals_;
  Matrix basis_;
  std::vector<double> weights_;
  std::vector<double> leverages_;
  std::size_t dof_ = 0;
  double scale_ = 0.0;
  double rounding_ = 0.0;
  double input_step_ = 0.0;
  bool has_noise_ = false;
  bool inputs_uncertain_ = false;
};

// The regressor of each term over the rows.
[[nodiscard]] std::vector<std::vector<double>> regressor_columns(const Dataset& rows, const TermList& terms);

// The residuals over their scale, held within 2.5: what a test for patterns looks at lest outliers decide it.
[[nodiscard]] std::vector<double> bounded(std::span<const double> residuals, double scale);

// By Student's t, of either sign.
[[nodiscard]] double student_probability(double t, double dof);

// Of a ratio of variances as large or larger, by Fisher's F.
[[nodiscard]] double fisher_probability(double ratio, double numerator, double denominator);

}  // namespace proofmass
