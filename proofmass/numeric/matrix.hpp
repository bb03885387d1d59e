// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace proofmass {

// A dense column-major matrix of doubles: element (r, c) at data[c * rows + r].
class Matrix {
 public:
  Matrix() = default;
  Matrix(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), data_(rows * columns, 0.0) {}

  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  [[nodiscard]] std::size_t columns() const noexcept { return columns_; }
  [[nodiscard]] double* data() noexcept { return data_.data(); }
  [[nodiscard]] const double* data() const noexcept { return data_.data(); }
  [[nodiscard]] double& operator()(std::size_t r, std::size_t c) noexcept { return data_[c * rows_ + r]; }
  [[nodiscard]] double operator()(std::size_t r, std::size_t c) const noexcept {
    return data_[c * rows_ + r];
  }
  [[nodiscard]] std::span<double> column(std::size_t c) noexcept { return {data_.data() + c * rows_, rows_}; }
  [[nodiscard]] std::span<const double> column(std::size_t c) const noexcept {
    return {data_.data() + c * rows_, rows_};
  }

 private:
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  std::vector<double> data_;
};

[[nodiscard]] inline Matrix scaled(Matrix matrix, double factor) {
  for (std::size_t c = 0; c < matrix.columns(); ++c) {
    for (double& value : matrix.column(c)) value *= factor;
  }
  return matrix;
}

}  // namespace proofmass
