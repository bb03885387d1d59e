// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/cholesky_kernel.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "proofmass/numeric/linear/cholesky_kernel.cpp"
#include <hwy/foreach_target.h>
// foreach_target includes this file once for every instruction set; the next header must come after it.
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "proofmass/numeric/simd/vector_type-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

// The matrix and the inverses of its pivots, for the columns factored so far.
struct PartFactors {
  double* matrix;
  std::size_t n, stride;
  double* inverse;

  [[nodiscard]] double* column(std::size_t c) const { return matrix + c * stride; }
  [[nodiscard]] std::size_t top(std::size_t c) const { return c / kLanes * kLanes; }
};

// Column j, from row `first` on, minus the products of the columns before it: kVectors vectors of rows. Every
// other column has its own sums, so that fewer products wait for the one before. Values above the diagonal in
// a vector count as zero, and are overwritten.
template <std::size_t kVectors>
HWY_INLINE void Eliminate(const PartFactors& factors, std::size_t j, std::size_t first) {
  double* const column = factors.column(j) + first;
  V rest[2][kVectors];
#pragma GCC unroll 5
  for (std::size_t i = 0; i < kVectors; ++i) {
    rest[0][i] = hn::Load(kD, column + i * kLanes);
    rest[1][i] = hn::Zero(kD);
  }
  if (first < j) rest[0][0] = hn::IfThenZeroElse(hn::FirstN(kD, j - first), rest[0][0]);
  const auto subtract = [&](std::size_t k, V(&sums)[kVectors]) HWY_ATTR {
    const double* const earlier = factors.column(k);
    const V factor = hn::Set(kD, earlier[j] * factors.inverse[k]);
#pragma GCC unroll 5
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
#pragma GCC unroll 5
  for (std::size_t i = 0; i < kVectors; ++i) {
    hn::Store(hn::Add(rest[0][i], rest[1][i]), kD, column + i * kLanes);
  }
}

// Number of vectors whose two sets of sums fit into the registers.
constexpr std::size_t kMost = 5;

// The last rows, at most kVectors vectors.
template <std::size_t kVectors>
HWY_INLINE void EliminateRest(const PartFactors& factors, std::size_t j, std::size_t first) {
  if (first + kVectors * kLanes == factors.stride) return Eliminate<kVectors>(factors, j, first);
  if constexpr (kVectors > 1) EliminateRest<kVectors - 1>(factors, j, first);
}

// Takes n³ / 6 multiplications, and half a vector more for each pair of columns. The sums of a column stay in
// registers while the columns before it are read. Columns stay multiplied by their pivot, so that the next
// one waits for a division but not for a root.
bool Factor(double* matrix, std::size_t n, std::size_t stride, double* inverse) {
  const PartFactors factors{matrix, n, stride, inverse};
  for (std::size_t j = 0; j < factors.n; ++j) {
    double* const column = factors.column(j);
    std::size_t first = factors.top(j);
    for (; first + kMost * kLanes < factors.stride; first += kMost * kLanes) {
      Eliminate<kMost>(factors, j, first);
    }
    EliminateRest<kMost>(factors, j, first);
    const double pivot = column[j];
    factors.inverse[j] = 1.0 / pivot;
    if (!(pivot > 0.0 && std::isfinite(pivot) && std::isfinite(factors.inverse[j]))) return false;
  }
  return true;
}

// The solution for -b. `rest` is scratch memory of one column.
void Solve(double* matrix, std::size_t n, std::size_t stride, double* inverse, const double* b, double* rest,
           double* solution) {
  const PartFactors factors{matrix, n, stride, inverse};
  std::transform(b, b + factors.n, rest, std::negate<>());
  std::fill(rest + factors.n, rest + factors.stride, 0.0);
  for (std::size_t j = 0; j < factors.n; ++j) {
    const double* const column = factors.column(j);
    solution[j] = rest[j] * factors.inverse[j];
    const V factor = hn::Set(kD, solution[j]);
    for (std::size_t at = factors.top(j); at < factors.stride; at += kLanes) {
      hn::Store(hn::NegMulAdd(factor, hn::Load(kD, column + at), hn::Load(kD, rest + at)), kD, rest + at);
    }
  }
  // From the last column to the first. The vector being solved stays in its register, with zeros for values
  // not yet known. Memory written value by value cannot be read as a vector without a wait.
  for (std::size_t top = factors.stride; top > 0; top -= kLanes) {
    V solved = hn::Zero(kD);
    for (std::size_t j = std::min(top, factors.n); j-- > top - kLanes;) {
      const double* const column = factors.column(j);
      V sum = hn::Mul(hn::Load(kD, column + top - kLanes), solved);
      for (std::size_t at = top; at < factors.stride; at += kLanes) {
        sum = hn::MulAdd(hn::Load(kD, column + at), hn::Load(kD, rest + at), sum);
      }
      solution[j] -= factors.inverse[j] * hn::GetLane(hn::SumOfLanes(kD, sum));
      const auto here = hn::Eq(hn::Iota(kD, 0.0), hn::Set(kD, static_cast<double>(j - (top - kLanes))));
      solved = hn::IfThenElse(here, hn::Set(kD, solution[j]), solved);
    }
    hn::Store(solved, kD, rest + top - kLanes);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace proofmass {

HWY_EXPORT(Factor);
HWY_EXPORT(Solve);

bool CholeskyFactors::factor() {
  const bool definite =
      HWY_DYNAMIC_DISPATCH(Factor)(matrix_.values.data(), matrix_.n, matrix_.stride, inverse_.data());
  // The rows of the padding must not hold NaN.
  if (!definite) std::fill(matrix_.values.begin(), matrix_.values.end(), 0.0);
  return definite;
}

void CholeskyFactors::solve(std::span<const double> b, std::span<double> solution) {
  HWY_DYNAMIC_DISPATCH(Solve)
  (matrix_.values.data(), matrix_.n, matrix_.stride, inverse_.data(), b.data(), rest_.data(),
   solution.data());
}

}  // namespace proofmass
#endif  // HWY_ONCE
