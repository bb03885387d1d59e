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

// acc[i][j] += sum of a_i b_i c_j, lane by lane, (a_i, b_i) the left columns and c_j the right ones, the last
// of which is one throughout with kOnes: kRows x kColumns sums in registers, kRows * kColumns multiplications
// for every vector of rows, with kPairs kRows more. Products with one are additions, which have ports of
// their own. With `first` acc is set, whatever it held.
template <bool kPairs, bool kOnes, std::size_t kRows, std::size_t kColumns>
HWY_NOINLINE void ProductTile(const Factors* left, const double* right, std::size_t rows, bool first,
                              double* HWY_RESTRICT acc) {
  V sums[kRows][kColumns];
#pragma GCC unroll 20
  for (std::size_t i = 0; i < kRows * kColumns; ++i) {
    sums[i / kColumns][i % kColumns] = first ? hn::Zero(kD) : hn::LoadU(kD, acc + i * kLanes);
  }
  for (std::size_t row = 0; row < rows; row += kLanes) {
    V product[kRows];
#pragma GCC unroll 2
    for (std::size_t i = 0; i < kRows; ++i) {
      product[i] = hn::LoadU(kD, left[i][0] + row);
      if constexpr (kPairs) product[i] = hn::Mul(product[i], hn::LoadU(kD, left[i][1] + row));
    }
    if constexpr (kOnes) {
#pragma GCC unroll 2
      for (std::size_t i = 0; i < kRows; ++i) {
        sums[i][kColumns - 1] = hn::Add(sums[i][kColumns - 1], product[i]);
      }
    }
#pragma GCC unroll 10
    for (std::size_t j = 0; j < (kOnes ? kColumns - 1 : kColumns); ++j) {
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
template <bool kPairs, bool kOnes, std::size_t kRows, std::size_t kColumns>
HWY_INLINE void ProductTiles(const Factors* left, const double* right, std::size_t columns, std::size_t rows,
                             bool first, double* acc) {
  if (columns == kColumns) return ProductTile<kPairs, kOnes, kRows, kColumns>(left, right, rows, first, acc);
  if constexpr (kColumns > 1) {
    ProductTiles<kPairs, kOnes, kRows, kColumns - 1>(left, right, columns, rows, first, acc);
  }
}

enum class WithOnes : bool { no, yes };

// Sums over all samples of products of pairs of columns (left) with single columns (right, one after the
// other in a block, and with ones as if a column of ones followed), block after block. Where the first pair
// has no second column, no pair has. With `upper` only elements of the upper triangle are computed, and those
// beside it that a tile holds.
class ProductSums {
 public:
  ProductSums(std::size_t rows, std::size_t columns, bool upper, WithOnes ones = WithOnes::no)
      : left(rows), columns_(columns + (ones == WithOnes::yes ? 1 : 0)), upper_(upper), ones_(ones) {}

  std::vector<Factors> left;
  const double* right = nullptr;

  // In values; whole cache lines.
  [[nodiscard]] std::size_t storage() const { return (left.size() * columns_ * (kLanes + 1) + 7) / 8 * 8; }
  // Storage for the sums, whatever it holds.
  void start(double* sums) {
    first_ = true;
    sums_ = sums;
    totals_ = sums + left.size() * columns_ * kLanes;
  }

  // The columns set before hold `rows` rows, at most kBlockRows.
  void add(std::size_t rows) {
    if (left.empty()) return;
    left[0][1] == nullptr ? add_tiles<false>(rows) : add_tiles<true>(rows);
    first_ = false;
  }

  // Sums up the lanes: after the last of one block or more, before any total is asked for.
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

  // The sum for element (i, j); that with ones is the last of a row.
  [[nodiscard]] double total(std::size_t i, std::size_t j) const { return totals_[i * columns_ + j]; }

 private:
  // Sixteen registers hold 2 x 5 sums with what feeds them, thirty-two 2 x 10.
  static constexpr std::size_t kMostColumns = HWY_TARGET <= HWY_AVX3 ? 10 : 5;

  template <bool kPairs>
  void add_tiles(std::size_t rows) {
    for_each_tile([this, rows](std::size_t i, std::size_t tall, std::size_t j, std::size_t wide, double* acc)
                      HWY_ATTR {
                        if (ones_ == WithOnes::yes && j + wide == columns_) {
                          add_tile<kPairs, true>(i, tall, j, wide, rows, acc);
                        } else {
                          add_tile<kPairs, false>(i, tall, j, wide, rows, acc);
                        }
                      });
  }

  template <bool kPairs, bool kOnes>
  HWY_INLINE void add_tile(std::size_t i, std::size_t tall, std::size_t j, std::size_t wide, std::size_t rows,
                           double* acc) {
    if (tall == 2) {
      ProductTiles<kPairs, kOnes, 2, kMostColumns>(&left[i], right + j * kStride, wide, rows, first_, acc);
    } else {
      ProductTiles<kPairs, kOnes, 1, kMostColumns>(&left[i], right + j * kStride, wide, rows, first_, acc);
    }
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
  WithOnes ones_;
  bool first_ = true;         // no block is added yet
  double* sums_ = nullptr;    // of each lane
  double* totals_ = nullptr;  // of all lanes
};

// Scratch memory for the sums of a pass and what else it needs, which is returned.
template <typename... Sums>
double* LayOut(std::size_t more, Sums&... sums) {
  double* next = kernel_scratch((sums.storage() + ...) + more);
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
