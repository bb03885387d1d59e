// SPDX-License-Identifier: Apache-2.0
// Cholesky factors of a small matrix and the solution of its equations, vectorised; the instruction set is
// chosen at run time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// A square matrix whose columns start at whole vectors.
struct PaddedSquare {
  explicit PaddedSquare(std::size_t size)
      : n(size),
        stride((size + Samples::kRowMultiple - 1) / Samples::kRowMultiple * Samples::kRowMultiple),
        values(size * stride) {}

  [[nodiscard]] double* column(std::size_t c) noexcept { return values.data() + c * stride; }
  [[nodiscard]] const double* column(std::size_t c) const noexcept { return values.data() + c * stride; }

  std::size_t n, stride;
  AlignedColumn values;
};

// Factors L D Lᵀ of a symmetric positive definite matrix, L with ones on its diagonal.
class CholeskyFactors {
 public:
  explicit CholeskyFactors(std::size_t n) : matrix_(n), inverse_(n), rest_(matrix_.stride) {}

  // Replaces all factors: write the matrix here, at least its lower triangle.
  [[nodiscard]] PaddedSquare& matrix() noexcept { return matrix_; }
  // Factors the matrix into L D. Returns false when a pivot is not positive and finite; the contents are then
  // invalid.
  [[nodiscard]] bool factor();
  // The solution for -b, n values of each.
  void solve(std::span<const double> b, std::span<double> solution);

  [[nodiscard]] const PaddedSquare& scaled_columns() const noexcept { return matrix_; }  // L D
  [[nodiscard]] std::span<const double> inverse_pivots() const noexcept { return inverse_; }

 private:
  PaddedSquare matrix_;
  std::vector<double> inverse_;
  AlignedColumn rest_;  // scratch of solve
};

}  // namespace proofmass
