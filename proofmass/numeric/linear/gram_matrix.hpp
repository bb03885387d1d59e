// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/linear/regression_rows.hpp"
#include "proofmass/numeric/simd/double_double.hpp"

namespace proofmass {

// Sums of products of the columns of a regression (the response last) over its rows. They are all that least
// squares needs, and their memory depends only on the number of columns. About twice the working precision
// (gram_kernels.hpp), so that forming AᵀA, which squares the condition number, costs no digits.
class GramMatrix {
 public:
  GramMatrix() = default;
  // `scales`: RegressionRows::scales(), one per regressor.
  explicit GramMatrix(std::span<const double> scales);

  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  [[nodiscard]] std::size_t regressors() const noexcept { return scales_.size(); }
  // The factor of each column before its products were taken; 1 for the response.
  [[nodiscard]] std::span<const double> scales() const noexcept { return scales_; }
  // Sum of products of two scaled columns, symmetric. Index regressors() is the response.
  [[nodiscard]] const DoubleDouble& operator()(std::size_t i, std::size_t j) const noexcept {
    return products_[i < j ? place(i, j) : place(j, i)];
  }
  // The smallest and the largest element of a scaled column.
  [[nodiscard]] double least(std::size_t c) const noexcept { return least_[c]; }
  [[nodiscard]] double greatest(std::size_t c) const noexcept { return greatest_[c]; }

  // The Gram matrix of these regressors, in this order, and the response.
  [[nodiscard]] GramMatrix select(std::span<const std::size_t> regressors) const;
  // Sets a regressor to zero in every row.
  void clear(std::size_t regressor);
  // Adds sums over other rows of the same columns.
  void add(const GramMatrix& other);

  // Access for the functions that form the sums.
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

// Sums the rows in one pass. The rows are divided into portions that depend only on their number, and the
// sums of the portions are added in order, so the result does not depend on the number of threads.
[[nodiscard]] GramMatrix gram_matrix(const RegressionRows& rows);

struct GramMatrices {
  GramMatrix plain;
  GramMatrix weighted;  // the sums of WeightedRows
};

// Sums with and without weights, in one pass. Throws std::invalid_argument unless there is one finite,
// non-negative weight per row.
[[nodiscard]] GramMatrices gram_matrices(const RegressionRows& rows, std::span<const double> weights);

}  // namespace proofmass
