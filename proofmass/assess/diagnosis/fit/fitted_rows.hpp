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
  FittedRows(const Dataset& record, std::span<const std::size_t> training, const Identification& result);

  [[nodiscard]] const Dataset& record() const noexcept { return record_; }
  [[nodiscard]] std::span<const double> residuals() const noexcept { return residuals_; }
  [[nodiscard]] std::size_t rows() const noexcept { return residuals_.size(); }
  [[nodiscard]] std::size_t dof() const noexcept { return dof_; }
  [[nodiscard]] double scale() const noexcept { return scale_; }  // robust, of the residuals
  // Whether the residuals are more than the rounding of the output, and enough to show a pattern.
  [[nodiscard]] bool has_noise() const noexcept { return has_noise_; }
  // The residuals over their scale, held within 2.5: what a test for patterns looks at.
  [[nodiscard]] std::span<const double> bounded() const noexcept { return bounded_; }
  // Mean square of bounded() per degree of freedom.
  [[nodiscard]] double bounded_variance() const noexcept { return bounded_variance_; }
  // Rows whose columns are orthonormal and span the terms of the fit: rows() x terms.
  [[nodiscard]] const Matrix& basis() const noexcept { return basis_; }

  // What of the values, one a row, no combination of the terms of the fit gives.
  [[nodiscard]] std::vector<double> beyond_terms(std::vector<double> values) const;
  // How far the slope of the residuals along `weights`, which are beyond the terms, lies from zero, by
  // standard errors for noise that differs from row to row (HC3: MacKinnon and White, J. Econometrics 29,
  // 1985). The probability is the larger of that and of a test on which outliers have little effect.
  [[nodiscard]] Departure departure(std::span<const double> weights) const;

 private:
  Dataset record_;
  std::vector<double> residuals_;
  Matrix basis_;
  std::vector<double> leverages_;  // of the terms
  std::size_t dof_ = 0;
  double scale_ = 0.0;
  bool has_noise_ = false;
  std::vector<double> bounded_;
  double bounded_variance_ = 1.0;
};

// What of the values no combination of the orthonormal columns of a basis gives.
[[nodiscard]] std::vector<double> beyond_columns(const Matrix& basis, std::vector<double> values);

[[nodiscard]] double sum_of_squares(std::span<const double> values);

// An orthonormal basis of these terms over the rows; of those only that the rows can tell apart.
[[nodiscard]] Matrix orthonormal_rows(const Dataset& rows, const TermList& terms);

// By Student's t, of either sign.
[[nodiscard]] double student_probability(double t, double dof);

}  // namespace proofmass
