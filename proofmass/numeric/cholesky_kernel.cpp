// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/cholesky_kernel.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "proofmass/numeric/cholesky_kernel.cpp"
#include <hwy/foreach_target.h>
// foreach_target includes this file once for every instruction set; the next header must come after it.
#include <hwy/highway.h>

#include <cmath>

#include "proofmass/numeric/vector_type-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

// Column j, from row `first` on, less the products of the columns before it: kVectors vectors of rows. Every
// other column goes to sums of its own, so that fewer products wait for the one before.
template <std::size_t kVectors>
HWY_INLINE void Eliminate(double* matrix, std::size_t stride, std::size_t j, std::size_t first) {
  double* const column = matrix + j * stride + first;
  V rest[2][kVectors];
#pragma GCC unroll 8
  for (std::size_t i = 0; i < kVectors; ++i) {
    rest[0][i] = hn::Load(kD, column + i * kLanes);
    rest[1][i] = hn::Zero(kD);
  }
  const auto subtract = [&](std::size_t k, V(&sums)[kVectors]) HWY_ATTR {
    const double* const earlier = matrix + k * stride;
    const V factor = hn::Set(kD, earlier[j]);
#pragma GCC unroll 8
    for (std::size_t i = 0; i < kVectors; ++i) {
      sums[i] = hn::NegMulAdd(factor, hn::Load(kD, earlier + first + i * kLanes), sums[i]);
    }
  };
  std::size_t k = 0;
  for (; k + 2 <= j; k += 2) {
    subtract(k, rest[0]);
    subtract(k + 1, rest[1]);
  }
  if (k < j) subtract(k, rest[0]);
#pragma GCC unroll 8
  for (std::size_t i = 0; i < kVectors; ++i) {
    hn::Store(hn::Add(rest[0][i], rest[1][i]), kD, column + i * kLanes);
  }
}

// n³ / 6 multiplications, and half a vector more for each pair of columns: the sums of a column stay in
// registers while those before it pass by. What a vector holds above the diagonal stays in its lane.
bool Cholesky(double* matrix, std::size_t n, std::size_t stride) {
  const std::size_t end = (n + kLanes - 1) / kLanes * kLanes;
  for (std::size_t j = 0; j < n; ++j) {
    double* const column = matrix + j * stride;
    const std::size_t top = j / kLanes * kLanes;
    std::size_t first = top;
    for (; first + 4 * kLanes <= end; first += 4 * kLanes) Eliminate<4>(matrix, stride, j, first);
    for (; first + 2 * kLanes <= end; first += 2 * kLanes) Eliminate<2>(matrix, stride, j, first);
    if (first < end) Eliminate<1>(matrix, stride, j, first);
    const double pivot = column[j];
    if (!(pivot > 0.0 && std::isfinite(pivot))) return false;
    const V scale = hn::Set(kD, 1.0 / std::sqrt(pivot));
    for (std::size_t at = top; at < end; at += kLanes) {
      hn::Store(hn::Mul(hn::Load(kD, column + at), scale), kD, column + at);
    }
    column[j] = std::sqrt(pivot);
  }
  return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace proofmass {

HWY_EXPORT(Cholesky);

bool cholesky_in_place(PaddedSquare& matrix) {
  return HWY_DYNAMIC_DISPATCH(Cholesky)(matrix.values.data(), matrix.n, matrix.stride);
}

}  // namespace proofmass
#endif  // HWY_ONCE
