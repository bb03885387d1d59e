// SPDX-License-Identifier: Apache-2.0
// Sums of products of columns in register tiles, compiled once for every instruction set. The file is
// included through foreach_target, so it has no ordinary include guard.
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
#include <utility>
#include <vector>

#include "proofmass/numeric/simd/block_columns.hpp"
#include "proofmass/numeric/simd/kernel_scratch_internal.hpp"
#include "proofmass/numeric/simd/vector_type-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kBlockRows = BlockColumns::kRows;
constexpr std::size_t kStride = BlockColumns::kStride;

// A left column, or a pair of left columns whose product is used.
using Factors = std::array<const double*, 2>;

// acc[i][j] += sum of a_i b_i c_j in each lane, with (a_i, b_i) the left columns and c_j the right ones. With
// kOnes the last right column is all ones. kRows x kColumns sums stay in registers. Every vector of rows
// takes kRows * kColumns multiplications, with kPairs kRows more. Products with one are additions, which have
// ports of their own. With `first`, acc is overwritten.
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

using TileKernel = void(const Factors* left, const double* right, std::size_t rows, bool first, double* acc);

// The tiles of 1, 2, … columns.
template <bool kPairs, bool kOnes, std::size_t kRows, std::size_t... kLess>
constexpr std::array<TileKernel*, sizeof...(kLess)> TilesByColumns(std::index_sequence<kLess...>) {
  return {&ProductTile<kPairs, kOnes, kRows, kLess + 1>...};
}

// Sums over all samples of products of (pairs of) left columns with single right columns, block after block.
// The right columns of a block are contiguous.
class ProductSums {
 public:
  struct Layout {
    std::size_t rows = 0;     // left columns, or pairs of them
    std::size_t columns = 0;  // right columns
    bool pairs = false;       // left columns are pairs
    bool ones = false;        // the right columns are followed by a column of ones, which is not stored
    bool upper = false;       // only elements of the upper triangle are wanted
  };

  explicit ProductSums(const Layout& layout)
      : left(layout.rows), layout_(layout), columns_(layout.columns + (layout.ones ? 1 : 0)) {}

  std::vector<Factors> left;
  const double* right = nullptr;

  // In values; a multiple of cache lines.
  [[nodiscard]] std::size_t storage() const { return (left.size() * columns_ * (kLanes + 1) + 7) / 8 * 8; }

  // Memory for the sums; its contents do not matter.
  void start(double* sums) {
    totals_ = sums + left.size() * columns_ * kLanes;
    first_ = true;
    tiles_.clear();
    tiles_.reserve((left.size() + 1) / 2 * ((columns_ + kMostColumns - 1) / kMostColumns));
    for (std::size_t i = 0; i < left.size(); i += 2) {
      const std::size_t tall = std::min<std::size_t>(2, left.size() - i);
      for (std::size_t j = layout_.upper ? i : 0; j < columns_; j += kMostColumns) {
        const std::size_t wide = std::min(kMostColumns, columns_ - j);
        tiles_.push_back({i, j, tall, wide, kernel(tall, j, wide), sums});
        sums += tall * wide * kLanes;
      }
    }
  }

  // The columns set before hold `rows` rows, at most kBlockRows.
  void add(std::size_t rows) {
    for (const Tile& tile : tiles_) {
      tile.kernel(&left[tile.row], right + tile.column * kStride, rows, first_, tile.sums);
    }
    first_ = false;
  }

  // Adds up the lanes. Call after the last of at least one block, before any total is read.
  void finish() {
    for (const Tile& tile : tiles_) {
      const double* sums = tile.sums;
      for (std::size_t r = tile.row; r < tile.row + tile.tall; ++r) {
        for (std::size_t c = tile.column; c < tile.column + tile.wide; ++c, sums += kLanes) {
          totals_[r * columns_ + c] = hn::GetLane(hn::SumOfLanes(kD, hn::LoadU(kD, sums)));
        }
      }
    }
  }

  // The sum for element (i, j). The sum with the column of ones is the last of a row.
  [[nodiscard]] double total(std::size_t i, std::size_t j) const { return totals_[i * columns_ + j]; }

 private:
  // Sixteen registers hold 2 x 5 sums and their operands, thirty-two 2 x 10.
  static constexpr std::size_t kMostColumns = HWY_TARGET <= HWY_AVX3 ? 10 : 5;

  struct Tile {
    std::size_t row, column, tall, wide;
    TileKernel* kernel;
    double* sums;  // one per lane
  };

  [[nodiscard]] TileKernel* kernel(std::size_t tall, std::size_t column, std::size_t wide) const {
    const bool ones = layout_.ones && column + wide == columns_;
    if (layout_.pairs) return ones ? kernel<true, true>(tall, wide) : kernel<true, false>(tall, wide);
    return ones ? kernel<false, true>(tall, wide) : kernel<false, false>(tall, wide);
  }

  template <bool kPairs, bool kOnes>
  [[nodiscard]] static TileKernel* kernel(std::size_t tall, std::size_t wide) {
    constexpr std::make_index_sequence<kMostColumns> kColumns;
    static constexpr auto kShort = TilesByColumns<kPairs, kOnes, 1>(kColumns);
    static constexpr auto kTall = TilesByColumns<kPairs, kOnes, 2>(kColumns);
    return tall == 1 ? kShort[wide - 1] : kTall[wide - 1];
  }

  Layout layout_;
  std::size_t columns_;  // including the column of ones
  std::vector<Tile> tiles_;
  bool first_ = true;         // no block has been added yet
  double* totals_ = nullptr;  // over all lanes
};

// Scratch memory for the sums of a pass; returns the part that is left for other use.
template <typename... Sums>
double* LayOut(std::size_t more, Sums&... sums) {
  double* next = kernel_scratch((sums.storage() + ...) + more);
  ((sums.start(next), next += sums.storage()), ...);
  return next;
}

// Calls body with the first row and the number of rows of each block.
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
