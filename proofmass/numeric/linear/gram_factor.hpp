// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "proofmass/numeric/linear/gram_matrix.hpp"
#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/simd/double_double.hpp"

namespace proofmass {

// The Cholesky factor of a Gram matrix (Golub & Van Loan, Matrix Computations, 4.2) in twice the working
// precision. It is the upper triangular R of the QR decomposition of the columns, which are scaled by further
// powers of two to lengths in [1/2, 1).
class GramFactor {
 public:
  explicit GramFactor(const GramMatrix& gram);

  [[nodiscard]] std::size_t columns() const noexcept { return scales_.size(); }
  // Powers of two: R belongs to the scaled columns of the Gram matrix times these.
  [[nodiscard]] const std::vector<double>& scales() const noexcept { return scales_; }
  // A column whose distance from the span of those before it, relative to its length, is below a quarter of
  // analyse_rank's tolerance has a zero row: it is skipped, and its small remainder is not subtracted from
  // later columns.
  [[nodiscard]] const DoubleDouble& operator()(std::size_t i, std::size_t j) const noexcept {
    return r_[j * columns() + i];
  }
  // R rounded to doubles.
  [[nodiscard]] Matrix rounded() const;
  // Qᵀ response, for the scaled columns.
  [[nodiscard]] const std::vector<DoubleDouble>& projection() const noexcept { return projection_; }
  // R⁻¹, upper triangular, column by column. R must have no zero on its diagonal.
  [[nodiscard]] std::vector<DoubleDouble> inverse() const;

 private:
  void eliminate(std::size_t pivot, std::vector<DoubleDouble>& rest);

  std::vector<double> scales_;
  std::vector<DoubleDouble> r_;
  std::vector<DoubleDouble> projection_;
};

}  // namespace proofmass
