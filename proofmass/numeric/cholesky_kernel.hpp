// SPDX-License-Identifier: Apache-2.0
// Cholesky's factor of a small matrix, vectorised, chosen at run time for the processor.
#pragma once

#include <cstddef>

#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// A square matrix whose columns start at whole vectors.
struct PaddedSquare {
  explicit PaddedSquare(std::size_t size)
      : n(size),
        stride((size + Samples::kRowMultiple - 1) / Samples::kRowMultiple * Samples::kRowMultiple),
        values(size * stride) {}

  [[nodiscard]] double* column(std::size_t c) noexcept { return values.data() + c * stride; }

  std::size_t n, stride;
  AlignedColumn values;
};

// Replaces the lower triangle of a symmetric positive definite matrix by L, with L Lᵀ the matrix; what stands
// above is spoilt. False where a pivot is not positive and finite: all is spoilt then.
[[nodiscard]] bool cholesky_in_place(PaddedSquare& matrix);

}  // namespace proofmass
