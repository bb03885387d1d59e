// SPDX-License-Identifier: Apache-2.0
// External criteria: the errors of a linear model with some columns of a design on rows that were not used
// for its coefficients.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

using Subset = std::uint32_t;  // bit k stands for column k, so at most 32 columns

// Thread-safe.
class SubsetCriterion {
 public:
  SubsetCriterion() = default;
  SubsetCriterion(const SubsetCriterion&) = delete;
  SubsetCriterion& operator=(const SubsetCriterion&) = delete;
  virtual ~SubsetCriterion() = default;

  [[nodiscard]] virtual std::size_t columns() const = 0;
  // A mean square, in the square of y's unit; smaller is better. The subset has at least one column.
  [[nodiscard]] virtual double value(Subset subset) const = 0;
  // A lower bound for the values of all subsets of this subset. Cheap; 0 when no better bound is known.
  [[nodiscard]] virtual double bound(Subset subset) const = 0;
};

// Rows of a regression: a design of full column rank, and one y per row.
struct Regression {
  const Matrix& design;
  std::span<const double> y;
};

// The three criteria reduce the rows by Householder QR once; the columns should have similar lengths. They
// throw std::invalid_argument when a part has fewer rows than columns, or when there are more than 32
// columns.

// Mean square of the errors at rows left out one by one, by the hat matrix: mean of (e_i / (1 - h_i))²
// (Allen, Technometrics 16, 1974). Bounded below by the mean squared residual. Infinite for a subset that
// some row alone determines in part (h = 1): without that row there is nothing to predict it from.
[[nodiscard]] std::unique_ptr<SubsetCriterion> press_criterion(const Regression& rows);

// Mean squared error over the checking rows, with coefficients from the fitting rows. Bounded below by the
// mean squared residual of the checking rows with their own coefficients.
[[nodiscard]] std::unique_ptr<SubsetCriterion> regularity_criterion(const Regression& fitting,
                                                                    const Regression& checking);

// Mean squared difference, over all rows, between the predictions of the two parts' coefficients. No bound.
[[nodiscard]] std::unique_ptr<SubsetCriterion> unbiasedness_criterion(const Regression& first,
                                                                      const Regression& second);

}  // namespace proofmass
