// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/linear/regression_rows.hpp"
#include "proofmass/numeric/simd/double_double.hpp"

namespace proofmass {

// Sums of products of the columns of a regression, the response last, over its rows: what least squares needs
// to know of them, in memory for the columns alone. In about twice the working precision (gram_kernels.hpp),
// so that forming AᵀA, which squares the condition number, costs no digits.
class GramMatrix {
 public:
  GramMatrix() = default;
  // `scales`: RegressionRows::scales(), one a regressor.
  explicit GramMatrix(std::span<const double> scales);

  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  [[nodiscard]] std::size_t regressors() const noexcept { return scales_.size(); }
  // What each column was multiplied by before its products were taken; the response by one.
  [[nodiscard]] std::span<const double> scales() const noexcept { return scales_; }
  // Of the scaled columns, symmetric; index regressors() is the response.
  [[nodiscard]] const DoubleDouble& operator()(std::size_t i, std::size_t j) const noexcept {
    return products_[i < j ? place(i, j) : place(j, i)];
  }
  // The smallest and the largest element of a scaled column.
  [[nodiscard]] double least(std::size_t c) const noexcept { return least_[c]; }
  [[nodiscard]] double greatest(std::size_t c) const noexcept { return greatest_[c]; }

  // That of the regressors named, in the order named, and the response.
  [[nodiscard]] GramMatrix select(std::span<const std::size_t> regressors) const;
  // Makes a regressor zero in every row.
  void clear(std::size_t regressor);
  // Adds sums over other rows of the same columns.
  void add(const GramMatrix& other);

  // For those that sum.
  void add_rows(std::size_t rows) noexcept { rows_ += rows; }
  void add_product(std::size_t i, std::size_t j, const DoubleDouble& sum) noexcept {
    products_[place(i, j)] = products_[place(i, j)] + sum;
  }
  void widen_range(std::size_t c, double least, double greatest) noexcept;

 private:
  [[nodiscard]] static std::size_t place(std::size_t i, std::size_t j) noexcept {
    return j * (j + 1) / 2 + i;
  }

  std::size_t rows_ = 0;
  std::vector<double> scales_;
  std::vector<DoubleDouble> products_;  // upper triangle, column by column
  std::vector<double> least_, greatest_;
};

// One pass over the rows. They are summed in shares that depend on their number alone, and the shares are
// added in order, so that the result does not depend on the number of threads.
[[nodiscard]] GramMatrix gram_matrix(const RegressionRows& rows);

struct GramMatrices {
  GramMatrix plain;
  GramMatrix weighted;  // that of WeightedRows
};

// Of the rows as they are and by weights, in one pass. Throws std::invalid_argument unless there is one
// weight a row, finite and not negative.
[[nodiscard]] GramMatrices gram_matrices(const RegressionRows& rows, std::span<const double> weights);

}  // namespace proofmass
