// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// A block of rows stored by column. The columns being multiplied stay in the first-level cache, all of them
// in the second.
class RowBlock {
 public:
  static constexpr std::size_t kRows = 256;

  explicit RowBlock(std::size_t columns) : columns_(columns), data_(columns * kStride, 0.0) {}

  [[nodiscard]] std::size_t columns() const noexcept { return columns_; }
  // kRows values; the first starts a cache line.
  [[nodiscard]] double* column(std::size_t c) noexcept { return data_.data() + c * kStride; }
  [[nodiscard]] const double* column(std::size_t c) const noexcept { return data_.data() + c * kStride; }

 private:
  static constexpr std::size_t kStride = kRows + 8;  // whole KiB would put columns into the same cache sets

  std::size_t columns_ = 0;
  AlignedColumn data_;
};

// The rows of a linear regression. They are generated block by block when needed, so that the whole matrix is
// never in memory.
class RegressionRows {
 public:
  RegressionRows() = default;
  RegressionRows(const RegressionRows&) = delete;
  RegressionRows& operator=(const RegressionRows&) = delete;
  virtual ~RegressionRows() = default;

  [[nodiscard]] virtual std::size_t rows() const noexcept = 0;
  // Powers of two, one per regressor. fill() writes the regressor times its power, which keeps sums of
  // squares in range.
  [[nodiscard]] virtual std::span<const double> scales() const noexcept = 0;
  // Writes rows first … first + count - 1 to the beginning of the block's columns, the response after the
  // regressors. Thread-safe.
  virtual void fill(std::size_t first, std::size_t count, RowBlock& block) const = 0;

  [[nodiscard]] std::size_t regressors() const noexcept { return scales().size(); }
};

// Rows of a matrix in memory. The matrix and y must outlive this object. Throws std::invalid_argument when
// their sizes differ or an element is not finite.
class MatrixRows final : public RegressionRows {
 public:
  MatrixRows(const Matrix& design, std::span<const double> y);
  [[nodiscard]] std::size_t rows() const noexcept override { return y_.size(); }
  [[nodiscard]] std::span<const double> scales() const noexcept override { return scales_; }
  void fill(std::size_t first, std::size_t count, RowBlock& block) const override;

 private:
  const Matrix& design_;
  std::span<const double> y_;
  std::vector<double> scales_;
};

// Throws std::invalid_argument unless there are `rows` weights, finite and not negative.
void require_weights(std::span<const double> weights, std::size_t rows);

// The rows of another object, which must outlive this one, times the square roots of weights: sums of squares
// over them are weighted sums (Golub & Van Loan, Matrix Computations, 6.1). A row of weight zero has no
// effect. Throws std::invalid_argument when a weight is negative or not finite, or there is not one for each
// row.
class WeightedRows final : public RegressionRows {
 public:
  WeightedRows(const RegressionRows& rows, std::vector<double> weights);
  [[nodiscard]] std::size_t rows() const noexcept override { return rows_.rows(); }
  [[nodiscard]] std::span<const double> scales() const noexcept override { return rows_.scales(); }
  void fill(std::size_t first, std::size_t count, RowBlock& block) const override;

 private:
  const RegressionRows& rows_;
  std::vector<double> weights_;
};

}  // namespace proofmass
