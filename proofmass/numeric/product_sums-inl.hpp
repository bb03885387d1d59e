// SPDX-License-Identifier: Apache-2.0
// Sums of products of columns in register tiles, compiled once for every instruction set: included through
// foreach_target, so without an ordinary include guard.
#if defined(PROOFMASS_PRODUCT_SUMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROOFMASS_PRODUCT_SUMS_INL
#undef PROOFMASS_PRODUCT_SUMS_INL
#else
#define PROOFMASS_PRODUCT_SUMS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "proofmass/numeric/block_columns.hpp"
#include "proofmass/numeric/kernel_scratch_internal.hpp"
#include "proofmass/numeric/vector_type-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kBlockRows = BlockColumns::kRows;
constexpr std::size_t kStride = BlockColumns::kStride;

// A left column, or a pair of them whose product is meant.
using Factors = std::array<const double*, 2>;

// acc[i][j] += sum of a_i b_i c_j, lane by lane, (a_i, b_i) the left columns and c_j the right ones: kRows x
// kColumns sums in registers, kRows * kColumns multiplications for every vector of rows, with kPairs kRows
// more.
template <bool kPairs, std::size_t kRows, std::size_t kColumns>
HWY_NOINLINE void ProductTile(const Factors* left, const double* right, std::size_t rows,
                              double* HWY_RESTRICT acc) {
  V sums[kRows][kColumns];
#pragma GCC unroll 20
  for (std::size_t i = 0; i < kRows * kColumns; ++i) {
    sums[i / kColumns][i % kColumns] = hn::LoadU(kD, acc + i * kLanes);
  }
  for (std::size_t row = 0; row < rows; row += kLanes) {
    V product[kRows];
#pragma GCC unroll 2
    for (std::size_t i = 0; i < kRows; ++i) {
      product[i] = hn::LoadU(kD, left[i][0] + row);
      if constexpr (kPairs) product[i] = hn::Mul(product[i], hn::LoadU(kD, left[i][1] + row));
    }
#pragma GCC unroll 10
    for (std::size_t j = 0; j < kColumns; ++j) {
      const V value = InRegister(hn::LoadU(kD, right + j * kStride + row));
#pragma GCC unroll 2
      for (std::size_t i = 0; i < kRows; ++i) sums[i][j] = hn::MulAdd(product[i], value, sums[i][j]);
    }
  }
#pragma GCC unroll 20
  for (std::size_t i = 0; i < kRows * kColumns; ++i) {
    hn::StoreU(sums[i / kColumns][i % kColumns], kD, acc + i * kLanes);
  }
}

// The tile for any number of columns up to kColumns.
template <bool kPairs, std::size_t kRows, std::size_t kColumns>
HWY_INLINE void ProductTiles(const Factors* left, const double* right, std::size_t columns, std::size_t rows,
                             double* acc) {
  if (columns == kColumns) return ProductTile<kPairs, kRows, kColumns>(left, right, rows, acc);
  if constexpr (kColumns > 1) ProductTiles<kPairs, kRows, kColumns - 1>(left, right, columns, rows, acc);
}

// Sums over all samples of products of pairs of columns (left) with single columns (right, one after the
// other in a block), block after block. Where the first pair has no second column, no pair has. With `upper`
// only elements of the upper triangle are computed, and those beside it that a tile holds.
class ProductSums {
 public:
  ProductSums(std::size_t rows, std::size_t columns, bool upper)
      : left(rows), columns_(columns), upper_(upper) {}

  std::vector<Factors> left;
  const double* right = nullptr;

  // In values; whole cache lines.
  [[nodiscard]] std::size_t storage() const { return (left.size() * columns_ * (kLanes + 1) + 7) / 8 * 8; }
  // Storage for the sums, all zero.
  void start(double* sums) {
    sums_ = sums;
    totals_ = sums + left.size() * columns_ * kLanes;
  }

  // The columns set before hold `rows` rows, at most kBlockRows.
  void add(std::size_t rows) {
    if (left.empty()) return;
    left[0][1] == nullptr ? add_tiles<false>(rows) : add_tiles<true>(rows);
  }

  // Sums up the lanes: after the last block, before any total is asked for.
  void finish() {
    for_each_tile(
        [this](std::size_t i, std::size_t tall, std::size_t j, std::size_t wide, const double* acc) HWY_ATTR {
          for (std::size_t r = 0; r < tall; ++r) {
            for (std::size_t c = 0; c < wide; ++c, acc += kLanes) {
              totals_[(i + r) * columns_ + j + c] = hn::GetLane(hn::SumOfLanes(kD, hn::LoadU(kD, acc)));
            }
          }
        });
  }

  // The sum for element (i, j).
  [[nodiscard]] double total(std::size_t i, std::size_t j) const { return totals_[i * columns_ + j]; }

 private:
  // Sixteen registers hold 2 x 5 sums with what feeds them, thirty-two 2 x 10.
  static constexpr std::size_t kMostColumns = HWY_TARGET <= HWY_AVX3 ? 10 : 5;

  template <bool kPairs>
  void add_tiles(std::size_t rows) {
    for_each_tile(
        [this, rows](std::size_t i, std::size_t tall, std::size_t j, std::size_t wide, double* acc) HWY_ATTR {
          if (tall == 2) {
            ProductTiles<kPairs, 2, kMostColumns>(&left[i], right + j * kStride, wide, rows, acc);
          } else {
            ProductTiles<kPairs, 1, kMostColumns>(&left[i], right + j * kStride, wide, rows, acc);
          }
        });
  }

  // Calls body with the first row and the rows of each tile, its first column and columns, and its sums.
  template <typename Body>
  HWY_INLINE void for_each_tile(const Body& body) {
    for (std::size_t i = 0; i < left.size(); i += 2) {
      const std::size_t tall = std::min<std::size_t>(2, left.size() - i);
      for (std::size_t j = upper_ ? i : 0; j < columns_; j += kMostColumns) {
        const std::size_t wide = std::min(kMostColumns, columns_ - j);
        body(i, tall, j, wide, sums_ + (i * columns_ + tall * j) * kLanes);
      }
    }
  }

  std::size_t columns_;
  bool upper_;
  double* sums_ = nullptr;    // of each lane
  double* totals_ = nullptr;  // of all lanes
};

// Scratch memory for the sums of a pass, all zero, and what else it needs, which is returned.
template <typename... Sums>
double* LayOut(std::size_t more, Sums&... sums) {
  const std::size_t size = (sums.storage() + ...);
  double* next = kernel_scratch(size + more);
  std::fill_n(next, size, 0.0);
  ((sums.start(next), next += sums.storage()), ...);
  return next;
}

// Calls body with the first row of each block and its rows.
template <typename Body>
HWY_INLINE void ForEachBlock(const Samples& samples, const Body& body) {
  for (std::size_t first = 0; first < samples.padded_rows(); first += kBlockRows) {
    body(first, std::min(kBlockRows, samples.padded_rows() - first));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_PRODUCT_SUMS_INL
