// SPDX-License-Identifier: Apache-2.0
// The mathematics of a block of samples, compiled once for every instruction set: included by
// perceptron_kernels.cpp through foreach_target, so without an ordinary include guard.
#if defined(PROOFMASS_PERCEPTRON_KERNELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROOFMASS_PERCEPTRON_KERNELS_INL
#undef PROOFMASS_PERCEPTRON_KERNELS_INL
#else
#define PROOFMASS_PERCEPTRON_KERNELS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "proofmass/numeric/perceptron_kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, Samples::kRowMultiple>;
using V = hn::Vec<D>;
constexpr D kD{};

// Rows of a block: its columns and its share of the accumulators stay in the first two levels of cache.
constexpr std::size_t kBlockRows = 128;

// tanh z = m / (m + 2) with m = exp(2z) - 1, relative error of a few units in the last place for every z: the
// last digits of training hang on it. exp by reduction to |r| <= ln 2 / 2 and a polynomial of degree 11
// (Chebyshev interpolation, relative error 1.7e-17). 22 vector operations and one division.
HWY_INLINE V Tanh(V z) {
  const auto constant = [](double c) HWY_ATTR { return hn::Set(kD, c); };
  const hn::RebindToUnsigned<D> du;
  const V t = hn::Min(constant(40.0), hn::Max(constant(-40.0), hn::Add(z, z)));
  // Adding 1.5 * 2^52 leaves the rounded integer in the low bits of the sum.
  const V magic = constant(6755399441055744.0);
  const V shifted = hn::MulAdd(t, constant(1.4426950408889634), magic);
  const V k = hn::Sub(shifted, magic);
  V r = hn::NegMulAdd(k, constant(0.693147180369123816490), t);
  r = hn::NegMulAdd(k, constant(1.90821492927058770002e-10), r);
  const V r2 = hn::Mul(r, r);
  const V r4 = hn::Mul(r2, r2);
  const V p01 = hn::MulAdd(constant(0.16666666666666669), r, constant(0.5000000000000001));
  const V p23 = hn::MulAdd(constant(0.008333333333330065), r, constant(0.041666666666624164));
  const V p45 = hn::MulAdd(constant(0.00019841269863040545), r, constant(0.0013888888917196719));
  const V p67 = hn::MulAdd(constant(2.7557268480310024e-06), r, constant(2.4801521322368692e-05));
  const V p89 = hn::MulAdd(constant(2.5100375832561234e-08), r, constant(2.7620075879983367e-07));
  const V low = hn::MulAdd(p23, r2, p01);
  const V high = hn::MulAdd(p67, r2, p45);
  const V p = hn::MulAdd(hn::MulAdd(p89, r4, high), r4, low);
  const V exponential_less_one = hn::MulAdd(r2, p, r);  // of r
  const auto exponent = hn::ShiftLeft<52>(hn::BitCast(du, shifted));
  const V scale = hn::BitCast(kD, hn::Add(hn::BitCast(du, constant(1.0)), exponent));
  const V m = hn::MulAdd(scale, exponential_less_one, hn::Sub(scale, constant(1.0)));
  const V tanh = hn::Div(m, hn::Add(m, constant(2.0)));
  // Min and Max pass on a second operand that is not a number, but not where Highway emulates them.
  if constexpr (HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128) {
    return hn::IfThenElse(hn::IsNaN(z), z, tanh);
  }
  return tanh;
}

// Weighted sum of the inputs of row `row` plus the bias: the argument of one hidden unit.
HWY_INLINE V HiddenArgument(const PerceptronShape& shape, const double* weights, std::size_t unit,
                            const Samples& samples, std::size_t row) {
  V z = hn::Set(kD, weights[shape.hidden * shape.inputs + unit]);
  for (std::size_t k = 0; k < shape.inputs; ++k) {
    z = hn::MulAdd(hn::Set(kD, weights[unit * shape.inputs + k]), hn::LoadU(kD, samples.input_data(k) + row),
                   z);
  }
  return z;
}

// Activations of one unit over rows [first, last), zero in the padding.
HWY_INLINE void HiddenColumn(const PerceptronShape& shape, const double* weights, std::size_t unit,
                             const Samples& samples, std::size_t first, std::size_t last, double* h) {
  for (std::size_t row = first; row < last; row += hn::Lanes(kD)) {
    const V mask = hn::LoadU(kD, samples.mask_data() + row);
    const V z = HiddenArgument(shape, weights, unit, samples, row);
    hn::StoreU(hn::Mul(mask, Tanh(z)), kD, h + (row - first));
  }
}

// Derivative of v * tanh(w . x + b) by b and w over rows [first, last), from the activations h of those rows:
// columns `stride` apart, one an input, then the bias at `bias`.
HWY_INLINE void HiddenDerivatives(const PerceptronShape& shape, double v, const double* h,
                                  const Samples& samples, std::size_t first, std::size_t last,
                                  double* columns, std::size_t stride, double* bias) {
  const V scale = hn::Set(kD, v);
  for (std::size_t row = first; row < last; row += hn::Lanes(kD)) {
    const std::size_t at = row - first;
    const V activation = hn::LoadU(kD, h + at);
    const V slope =
        hn::Mul(scale, hn::NegMulAdd(activation, activation, hn::LoadU(kD, samples.mask_data() + row)));
    hn::StoreU(slope, kD, bias + at);
    for (std::size_t k = 0; k < shape.inputs; ++k) {
      hn::StoreU(hn::Mul(slope, hn::LoadU(kD, samples.input_data(k) + row)), kD, columns + k * stride + at);
    }
  }
}

// acc[i][j] += left_i . right_j lane by lane, for a tile of kTileRows x kTileColumns columns kept in
// registers.
constexpr std::size_t kTileRows = 4;
constexpr std::size_t kTileColumns = HWY_TARGET <= HWY_AVX3 ? 4 : 2;

HWY_INLINE void ProductTile(const double* const* left, const double* const* right, std::size_t rows,
                            double* acc) {
  constexpr std::size_t kLanes =
      HWY_LANES(double) < Samples::kRowMultiple ? HWY_LANES(double) : Samples::kRowMultiple;
  V sums[kTileRows][kTileColumns];
#pragma GCC unroll 4
  for (std::size_t i = 0; i < kTileRows; ++i) {
#pragma GCC unroll 4
    for (std::size_t j = 0; j < kTileColumns; ++j)
      sums[i][j] = hn::LoadU(kD, acc + (i * kTileColumns + j) * kLanes);
  }
  for (std::size_t row = 0; row < rows; row += kLanes) {
    V b[kTileColumns];
#pragma GCC unroll 4
    for (std::size_t j = 0; j < kTileColumns; ++j) b[j] = hn::LoadU(kD, right[j] + row);
#pragma GCC unroll 4
    for (std::size_t i = 0; i < kTileRows; ++i) {
      const V a = hn::LoadU(kD, left[i] + row);
#pragma GCC unroll 4
      for (std::size_t j = 0; j < kTileColumns; ++j) sums[i][j] = hn::MulAdd(a, b[j], sums[i][j]);
    }
  }
#pragma GCC unroll 4
  for (std::size_t i = 0; i < kTileRows; ++i) {
#pragma GCC unroll 4
    for (std::size_t j = 0; j < kTileColumns; ++j)
      hn::StoreU(sums[i][j], kD, acc + (i * kTileColumns + j) * kLanes);
  }
}

// Sums of products of the columns of one list with those of another, block after block. With `upper` only the
// tiles that reach the upper triangle are computed.
class ProductSums {
 public:
  ProductSums(std::size_t left, std::size_t right, bool upper)
      : left_((left + kTileRows - 1) / kTileRows * kTileRows),
        right_((right + kTileColumns - 1) / kTileColumns * kTileColumns),
        upper_(upper),
        sums_(left_ * right_ * hn::Lanes(kD), 0.0),
        zeros_(kBlockRows, 0.0),
        left_columns_(left_, zeros_.data()),
        right_columns_(right_, zeros_.data()) {}

  void set_left(std::size_t i, const double* column) { left_columns_[i] = column; }
  void set_right(std::size_t j, const double* column) { right_columns_[j] = column; }

  // The columns set before hold `rows` rows, at most kBlockRows.
  void add(std::size_t rows) {
    for (std::size_t i = 0; i < left_; i += kTileRows) {
      for (std::size_t j = 0; j < right_; j += kTileColumns) {
        if (upper_ && j + kTileColumns <= i) continue;
        ProductTile(&left_columns_[i], &right_columns_[j], rows, tile(i, j));
      }
    }
  }

  // The sum of products of column i of the left list and column j of the right.
  [[nodiscard]] double sum(std::size_t i, std::size_t j) {
    const std::size_t ti = i / kTileRows * kTileRows;
    const std::size_t tj = j / kTileColumns * kTileColumns;
    const double* lanes = tile(ti, tj) + ((i - ti) * kTileColumns + (j - tj)) * hn::Lanes(kD);
    return hn::GetLane(hn::SumOfLanes(kD, hn::LoadU(kD, lanes)));
  }

 private:
  double* tile(std::size_t i, std::size_t j) {
    return sums_.data() + (i * right_ + j * kTileRows) * hn::Lanes(kD);
  }

  std::size_t left_, right_;
  bool upper_;
  AlignedColumn sums_, zeros_;
  std::vector<const double*> left_columns_, right_columns_;
};

// v = target - phi * coefficients for one vector of rows.
HWY_INLINE V ResidualVector(const ColumnBlock& phi, const double* coefficients, const Samples& samples,
                            std::size_t row) {
  V e = hn::LoadU(kD, samples.target_data() + row);
  for (std::size_t c = 0; c < phi.columns(); ++c) {
    e = hn::NegMulAdd(hn::Set(kD, coefficients[c]), hn::LoadU(kD, phi.column(c) + row), e);
  }
  return e;
}

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_PERCEPTRON_KERNELS_INL
