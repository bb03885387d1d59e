// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/gram_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "proofmass/numeric/linear/gram_kernels.cpp"
#include <hwy/foreach_target.h>
// foreach_target includes this file once for every instruction set; the next header must come after it.
#include "proofmass/numeric/linear/gram_kernels-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

std::size_t Padded(std::size_t count) { return (count + kLanes - 1) / kLanes * kLanes; }

// The sums of one pass, tile by tile over the upper triangle, with one sum per lane.
class TiledSums {
 public:
  explicit TiledSums(std::size_t columns)
      : columns_(columns),
        zeros_(RowBlock::kRows, 0.0),
        pointers_(columns + kTileRows, zeros_.data()),
        bounds_(columns + kTileRows, 0.0) {
    for (std::size_t i = 0; i < columns; i += kTileRows) {
      for (std::size_t j = i; j < columns; j += kTileColumns) tiles_.push_back({i, j});
    }
    sums_.assign(tiles_.size() * 2 * kTile * kLanes, 0.0);
  }

  // Adds `count` rows of a block, padded with zeros to a multiple of kLanes, and updates the ranges for the
  // next sums.
  void add(const RowBlock& block, std::size_t count, GramMatrix& gram) {
    for (std::size_t c = 0; c < columns_; ++c) {
      const Range range = RangeOf(block.column(c), count);
      gram.widen_range(c, range.least, range.greatest);
      pointers_[c] = block.column(c);
      bounds_[c] = PowerAbove(std::max(-range.least, range.greatest));
    }
    for (std::size_t first = 0; first < Padded(count); first += kMostOfLane * kLanes) {
      add(first, std::min(first + kMostOfLane * kLanes, Padded(count)));
    }
  }

  void add_to(GramMatrix& gram) const {
    const double* sums = sums_.data();
    for (const Tile& tile : tiles_) {
      for (std::size_t k = 0; k < kTile; ++k) {
        const std::size_t i = tile.i + k / kTileColumns;
        const std::size_t j = tile.j + k % kTileColumns;
        if (i > j || j >= columns_) continue;
        DoubleDouble sum;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          sum = sum + exact_sum(sums[k * kLanes + lane], sums[(kTile + k) * kLanes + lane]);
        }
        gram.add_product(i, j, sum);
      }
      sums += 2 * kTile * kLanes;
    }
  }

 private:
  struct Tile {
    std::size_t i, j;
  };

  void add(std::size_t first, std::size_t last) {
    const double unit = Anchor(last - first);
    double* sums = sums_.data();
    for (const Tile& tile : tiles_) {
      double anchors[kTile];
      for (std::size_t k = 0; k < kTile; ++k) {
        anchors[k] = unit * bounds_[tile.i + k / kTileColumns] * bounds_[tile.j + k % kTileColumns];
      }
      AddTile(&pointers_[tile.i], &pointers_[tile.j], first, last, anchors, sums);
      sums += 2 * kTile * kLanes;
    }
  }

  std::size_t columns_;
  AlignedColumn zeros_;
  std::vector<const double*> pointers_;
  std::vector<double> bounds_;  // powers of two above the columns' largest magnitudes
  std::vector<Tile> tiles_;
  AlignedColumn sums_;
};

// Fills the block with rows from `first` on and pads it with zeros; returns how many rows it holds.
std::size_t FillPadded(const RegressionRows& rows, std::size_t first, std::size_t last, RowBlock& block) {
  const std::size_t count = std::min(RowBlock::kRows, last - first);
  rows.fill(first, count, block);
  if (count < RowBlock::kRows) {
    for (std::size_t c = 0; c < block.columns(); ++c) {
      std::fill(block.column(c) + count, block.column(c) + RowBlock::kRows, 0.0);
    }
  }
  return count;
}

// Multiplies the rows of a block by the square roots of weights.
void WeighBlock(const double* weights, std::size_t count, RowBlock& block) {
  HWY_ALIGN double factors[RowBlock::kRows] = {};
  std::copy_n(weights, count, factors);
  for (std::size_t r = 0; r < count; r += kLanes) {
    hn::Store(hn::Sqrt(hn::Load(kD, factors + r)), kD, factors + r);
  }
  for (std::size_t c = 0; c < block.columns(); ++c) {
    double* const column = block.column(c);
    for (std::size_t r = 0; r < count; r += kLanes) {
      hn::StoreU(hn::Mul(hn::LoadU(kD, column + r), hn::Load(kD, factors + r)), kD, column + r);
    }
  }
}

// Without weights there are no weighted sums.
void AddProducts(const RegressionRows& rows, const double* weights, std::size_t first, std::size_t last,
                 GramMatrix& gram, GramMatrix* weighted) {
  const std::size_t columns = rows.regressors() + 1;
  RowBlock block(columns);
  TiledSums sums(columns), weighted_sums(weights != nullptr ? columns : 0);
  for (std::size_t row = first; row < last; row += RowBlock::kRows) {
    const std::size_t count = FillPadded(rows, row, last, block);
    sums.add(block, count, gram);
    if (weights == nullptr) continue;
    WeighBlock(weights + row, count, block);
    weighted_sums.add(block, count, *weighted);
  }
  sums.add_to(gram);
  gram.add_rows(last - first);
  if (weights == nullptr) return;
  weighted_sums.add_to(*weighted);
  weighted->add_rows(last - first);
}

// Calls make(block, row) for each vector of rows and stores what it returns.
template <typename Make>
HWY_INLINE void ForEachVector(const RegressionRows& rows, std::size_t first, std::size_t last, double* result,
                              const Make& make) {
  RowBlock block(rows.regressors() + 1);
  AlignedColumn values(RowBlock::kRows);
  for (std::size_t row = first; row < last; row += RowBlock::kRows) {
    const std::size_t count = FillPadded(rows, row, last, block);
    for (std::size_t r = 0; r < count; r += kLanes) hn::StoreU(make(block, r), kD, values.data() + r);
    std::copy_n(values.begin(), count, result + (row - first));
  }
}

void Residuals(const RegressionRows& rows, const double* coefficients, std::size_t first, std::size_t last,
               double* residuals) {
  ForEachVector(rows, first, last, residuals, [&](const RowBlock& block, std::size_t row) HWY_ATTR {
    return Residual(block, coefficients, rows.regressors(), row);
  });
}

void SquaredLengths(const RegressionRows& rows, const Matrix& transform, std::size_t first, std::size_t last,
                    double* lengths) {
  ForEachVector(rows, first, last, lengths, [&](const RowBlock& block, std::size_t row) HWY_ATTR {
    return SquaredLength(block, transform, row);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace proofmass {

HWY_EXPORT(AddProducts);
HWY_EXPORT(Residuals);
HWY_EXPORT(SquaredLengths);

void add_products(const RegressionRows& rows, std::size_t first, std::size_t last, GramMatrix& sums) {
  HWY_DYNAMIC_DISPATCH(AddProducts)(rows, nullptr, first, last, sums, nullptr);
}

void add_products(const RegressionRows& rows, std::span<const double> weights, std::size_t first,
                  std::size_t last, GramMatrix& sums, GramMatrix& weighted) {
  HWY_DYNAMIC_DISPATCH(AddProducts)(rows, weights.data(), first, last, sums, &weighted);
}

void compute_residuals(const RegressionRows& rows, std::span<const double> coefficients, std::size_t first,
                       std::size_t last, std::span<double> residuals) {
  HWY_DYNAMIC_DISPATCH(Residuals)(rows, coefficients.data(), first, last, residuals.data());
}

void compute_squared_lengths(const RegressionRows& rows, const Matrix& transform, std::size_t first,
                             std::size_t last, std::span<double> lengths) {
  HWY_DYNAMIC_DISPATCH(SquaredLengths)(rows, transform, first, last, lengths.data());
}

}  // namespace proofmass
#endif  // HWY_ONCE
