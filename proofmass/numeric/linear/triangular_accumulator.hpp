// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// The triangular factor R of a tall matrix that is given block by block of rows (Householder QR of R over the
// block: sequential TSQR, Demmel et al. 2012). Its memory does not grow with the rows.
class TriangularAccumulator {
 public:
  explicit TriangularAccumulator(std::size_t columns) : r_(columns, columns) {}
  // Adds the first `rows` rows of the block, which has as many columns as the accumulator.
  void add(const Matrix& block, std::size_t rows);
  // Upper triangular, columns x columns, RᵀR = AᵀA. Rows beyond the rank of the rows added are zero.
  [[nodiscard]] const Matrix& r() const noexcept { return r_; }

 private:
  Matrix r_;
};

}  // namespace proofmass
