// SPDX-License-Identifier: Apache-2.0
// The mathematics of a block of rows, compiled once for every instruction set. gram_kernels.cpp includes this
// file through foreach_target, so it has no ordinary include guard.
#if defined(PROOFMASS_GRAM_KERNELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROOFMASS_GRAM_KERNELS_INL
#undef PROOFMASS_GRAM_KERNELS_INL
#else
#define PROOFMASS_GRAM_KERNELS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "proofmass/numeric/linear/gram_kernels.hpp"
#include "proofmass/numeric/simd/vector_type-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

// The rounding error of a product: a b - p for p = fl(a b), or for a p near it.
#if HWY_NATIVE_FMA
using Factor = V;
HWY_INLINE Factor MakeFactor(V value) { return value; }
// Adds one product to high + low; see gram_kernels.hpp.
HWY_INLINE void AddProduct(Factor a, Factor b, V& high, V& low) {
  const V sum = hn::MulAdd(a, b, high);
  low = hn::Add(low, hn::MulSub(a, b, hn::Sub(sum, high)));
  high = sum;
}
HWY_INLINE V ProductError(Factor a, Factor b, V product) { return hn::MulSub(a, b, product); }
#else
// Halves of 26 bits, whose products are exact (Dekker, Numer. Math. 18, 1971).
struct Factor {
  V value, upper, lower;
};
HWY_INLINE Factor MakeFactor(V value) {
  const V shifted = hn::Mul(value, hn::Set(kD, 134217729.0));  // 2^27 + 1
  const V upper = hn::Sub(shifted, hn::Sub(shifted, value));
  return {value, upper, hn::Sub(value, upper)};
}
HWY_INLINE V ProductError(const Factor& a, const Factor& b, V product) {
  V error = hn::Sub(hn::Mul(a.upper, b.upper), product);
  error = hn::Add(error, hn::Mul(a.upper, b.lower));
  error = hn::Add(error, hn::Mul(a.lower, b.upper));
  return hn::Add(error, hn::Mul(a.lower, b.lower));
}
HWY_INLINE void AddProduct(const Factor& a, const Factor& b, V& high, V& low) {
  const V product = hn::Mul(a.value, b.value);
  const V sum = hn::Add(high, product);
  const V rest = hn::Sub(product, hn::Sub(sum, high));
  low = hn::Add(low, hn::Add(rest, ProductError(a, b, product)));
  high = sum;
}
#endif

// Algorithm 2Sum (Knuth): high + value, with its error added to low.
HWY_INLINE void AddExactly(V value, V& high, V& low) {
  const V sum = hn::Add(high, value);
  const V shadow = hn::Sub(sum, high);
  const V error = hn::Add(hn::Sub(high, hn::Sub(sum, shadow)), hn::Sub(value, shadow));
  low = hn::Add(low, error);
  high = sum;
}

// Sums of products of the columns of two lists, kTileRows x kTileColumns of them in registers. With 32
// registers twice as many fit.
constexpr std::size_t kTileRows = HWY_TARGET <= HWY_AVX3 ? 4 : 2;
constexpr std::size_t kTileColumns = 2;
constexpr std::size_t kTile = kTileRows * kTileColumns;

// For factors below one: a constant to which a lane's sum over a block can be added without leaving [2^e,
// 2^(e+1)]. It is 1.5 * 2^e, with 2^e at least twice the rows of a lane.
HWY_INLINE double Anchor(std::size_t rows) {
  return 1.5 * 2.0 * static_cast<double>(std::bit_ceil(rows / kLanes));
}

// Rows of a lane whose sum starts at one constant; more rows would cost digits.
constexpr std::size_t kMostOfLane = 128;

// Adds the sums over rows first … last - 1 of one block, padded with zeros to a multiple of kLanes, to
// `sums`: kTile vectors of high parts, then as many of low parts. `anchors`: kTile constants.
HWY_INLINE void AddTile(const double* const* left, const double* const* right, std::size_t first,
                        std::size_t last, const double* anchors, double* sums) {
  V high[kTile];
  V low[kTile];
#pragma GCC unroll 8
  for (std::size_t k = 0; k < kTile; ++k) {
    high[k] = hn::Set(kD, anchors[k]);
    low[k] = hn::Zero(kD);
  }
  for (std::size_t row = first; row < last; row += kLanes) {
    Factor b[kTileColumns];
#pragma GCC unroll 4
    for (std::size_t j = 0; j < kTileColumns; ++j) b[j] = MakeFactor(hn::LoadU(kD, right[j] + row));
#pragma GCC unroll 4
    for (std::size_t i = 0; i < kTileRows; ++i) {
      const Factor a = MakeFactor(hn::LoadU(kD, left[i] + row));
#pragma GCC unroll 4
      for (std::size_t j = 0; j < kTileColumns; ++j) {
        AddProduct(a, b[j], high[i * kTileColumns + j], low[i * kTileColumns + j]);
      }
    }
  }
#pragma GCC unroll 8
  for (std::size_t k = 0; k < kTile; ++k) {
    V total_high = hn::LoadU(kD, sums + k * kLanes);
    V total_low = hn::LoadU(kD, sums + (kTile + k) * kLanes);
    AddExactly(hn::Sub(high[k], hn::Set(kD, anchors[k])), total_high, total_low);
    hn::StoreU(total_high, kD, sums + k * kLanes);
    hn::StoreU(hn::Add(total_low, low[k]), kD, sums + (kTile + k) * kLanes);
  }
}

struct Range {
  double least, greatest;
};

HWY_INLINE Range RangeOf(const double* column, std::size_t rows) {
  Range range{column[0], column[0]};
  std::size_t row = 0;
  if (rows >= kLanes) {
    V least = hn::LoadU(kD, column);
    V greatest = least;
    for (row = kLanes; row + kLanes <= rows; row += kLanes) {
      const V value = hn::LoadU(kD, column + row);
      least = hn::Min(least, value);
      greatest = hn::Max(greatest, value);
    }
    range = {hn::GetLane(hn::MinOfLanes(kD, least)), hn::GetLane(hn::MaxOfLanes(kD, greatest))};
  }
  for (; row < rows; ++row) {
    range = {std::min(range.least, column[row]), std::max(range.greatest, column[row])};
  }
  return range;
}

// The least power of two above a magnitude; 0 for 0 and for magnitudes too small to be normal.
HWY_INLINE double PowerAbove(double magnitude) {
  constexpr std::uint64_t exponent_bits = 0x7FF0000000000000;
  return 2.0 * std::bit_cast<double>(std::bit_cast<std::uint64_t>(magnitude) & exponent_bits);
}

// y - columns * coefficients for one vector of rows, by algorithm Dot2.
HWY_INLINE V Residual(const RowBlock& block, const double* coefficients, std::size_t n, std::size_t row) {
  V high = hn::LoadU(kD, block.column(n) + row);
  V low = hn::Zero(kD);
  for (std::size_t c = 0; c < n; ++c) {
    const Factor a = MakeFactor(hn::LoadU(kD, block.column(c) + row));
    const V coefficient = hn::Set(kD, -coefficients[c]);
    const V product = hn::Mul(hn::LoadU(kD, block.column(c) + row), coefficient);
    low = hn::Add(low, ProductError(a, MakeFactor(coefficient), product));
    AddExactly(product, high, low);
  }
  return hn::Add(high, low);
}

// |row * transform|² for one vector of rows, transform upper triangular.
HWY_INLINE V SquaredLength(const RowBlock& block, const Matrix& transform, std::size_t row) {
  V square = hn::Zero(kD);
  for (std::size_t c = 0; c < transform.columns(); ++c) {
    V value = hn::Zero(kD);
    for (std::size_t k = 0; k <= c; ++k) {
      value = hn::MulAdd(hn::Set(kD, transform(k, c)), hn::LoadU(kD, block.column(k) + row), value);
    }
    square = hn::MulAdd(value, value, square);
  }
  return square;
}

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_GRAM_KERNELS_INL
