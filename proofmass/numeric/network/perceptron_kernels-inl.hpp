// SPDX-License-Identifier: Apache-2.0
// The mathematics of a block of samples, compiled once for every instruction set. The file is included
// through foreach_target, so it has no ordinary include guard.
//
// Operations of the multiplication ports per sample, for I inputs, H hidden units and p = H (I + 1) hidden
// weights, on 2 x 10 tiles. tanh takes T = 13, with AVX2 15:
//   activations, error    H (I + T + 1)
//   slopes                H, weighted 2 H
//   JᵀJ, Jᵀe, eᵀe         by slopes and products of inputs: I (I + 1) / 2 + H (H + 1) / 2 (1 + I (I + 3) / 2)
//                         + H I (H + 2) + H (H + 1) + (H + 1) (H + 2) / 2
// 3-7-1: 119 for activations and error, 693 for the normal equations by all weights including them (a dense
// JᵀJ with Jᵀe and eᵀe alone would take 703). Triangles take one more for every two rows, for the element
// below the diagonal that a tile contains.
#if defined(PROOFMASS_PERCEPTRON_KERNELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROOFMASS_PERCEPTRON_KERNELS_INL
#undef PROOFMASS_PERCEPTRON_KERNELS_INL
#else
#define PROOFMASS_PERCEPTRON_KERNELS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include "proofmass/numeric/network/perceptron_kernels.hpp"
#include "proofmass/numeric/simd/hyperbolic_tangent-inl.hpp"
#include "proofmass/numeric/simd/product_sums-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

// A network whose output is linear in further columns. All its weights, those of the fixed columns last, and
// the hidden weights a second time, scaled so that arguments are exponents of two.
struct Network {
  Network(const PerceptronShape& the_shape, const double* all_weights, const ColumnBlock& fixed_columns)
      : shape(the_shape),
        output(all_weights + the_shape.hidden_weights()),
        fixed(fixed_columns),
        exponents(the_shape.hidden_weights()) {
    // An infinite weight times the padding's zeros would give NaN.
    std::transform(all_weights, output, exponents.begin(), [](double w) {
      constexpr double kLargest = std::numeric_limits<double>::max();
      return std::isinf(w) ? w : std::clamp(kPowerOfTwo * w, -kLargest, kLargest);
    });
  }

  const PerceptronShape& shape;
  const double* output;
  const ColumnBlock& fixed;
  std::vector<double> exponents;
};

// Calls body with the number of inputs as a compile-time constant for the usual numbers, so that loops over
// inputs unroll; otherwise with 0.
template <typename Body>
HWY_INLINE void WithInputs(std::size_t inputs, const Body& body) {
  switch (inputs) {
    case 1:
      return body(std::integral_constant<std::size_t, 1>());
    case 2:
      return body(std::integral_constant<std::size_t, 2>());
    case 3:
      return body(std::integral_constant<std::size_t, 3>());
    default:
      return body(std::integral_constant<std::size_t, 0>());
  }
}

// Vectors of rows that a kernel processes together: enough that no step waits for the one before, and no more
// than fit into the registers.
constexpr std::size_t kTogether = 4;
constexpr std::size_t kTogetherForward = HWY_TARGET <= HWY_AVX3 ? 6 : 4;

// Calls body with the first row for kMost vectors of rows at a time, then for half as many, and so on down to
// 1. A vector processed alone would wait for each of its steps.
template <std::size_t kMost = kTogether, typename Body>
HWY_INLINE void ForRows(std::size_t rows, const Body& body, std::size_t row = 0) {
  for (; row + kMost * kLanes <= rows; row += kMost * kLanes) {
    body(row, std::integral_constant<std::size_t, kMost>());
  }
  if constexpr (kMost > 1) ForRows<kMost / 2>(rows, body, row);
}

// z = weighted sum of the inputs plus the bias, for the rows from `row` on: the argument of one hidden unit.
template <std::size_t kInputs, std::size_t kVectors>
HWY_INLINE void HiddenArgument(const PerceptronShape& shape, const double* weights, std::size_t unit,
                               const Samples& samples, std::size_t row, V (&z)[kVectors]) {
  const std::size_t inputs = kInputs > 0 ? kInputs : shape.inputs;
  const V bias = hn::Set(kD, weights[shape.hidden * inputs + unit]);
  Each<kVectors>([&](std::size_t i) HWY_ATTR { z[i] = bias; });
#pragma GCC unroll 3
  for (std::size_t k = 0; k < inputs; ++k) {
    const V weight = hn::Set(kD, weights[unit * inputs + k]);
    const double* const x = Fresh(samples.input_data(k) + row);
    Each<kVectors>([&](std::size_t i)
                       HWY_ATTR { z[i] = hn::MulAdd(weight, hn::LoadU(kD, x + i * kLanes), z[i]); });
  }
}

HWY_INLINE void ClearPadding(double* column, std::size_t real, std::size_t rows) {
  std::fill(column + std::min(real, rows), column + rows, 0.0);
}

// The columns of a pass for one block of rows.
struct HiddenColumns {
  double* activation = nullptr;  // one column per unit
  double* slope = nullptr;       // 1 - activation², one column per unit; null when not needed
  double* error = nullptr;       // target minus output; null when not needed
  bool weighted = false;         // slopes are multiplied by the unit's output weight
};

// Fills the columns for kVectors vectors of rows. The first row is `at` within the block and `first + at`
// within the samples. Activations are not computed again when they are kept.
template <bool kKept, std::size_t kInputs, std::size_t kVectors>
HWY_INLINE void HiddenRows(const Network& network, const Samples& samples, std::size_t first, std::size_t at,
                           const HiddenColumns& columns) {
  const PerceptronShape& shape = network.shape;
  const double* const v = network.output;
  V error[kVectors];
  Each<kVectors>([&](std::size_t i) HWY_ATTR {
    error[i] =
        hn::Sub(hn::LoadU(kD, samples.target_data() + first + at + i * kLanes), hn::Set(kD, v[shape.hidden]));
  });
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    double* const activation = columns.activation + j * kStride + at;
    V h[kVectors];
    if constexpr (kKept) {
      Each<kVectors>([&](std::size_t i) HWY_ATTR { h[i] = hn::LoadU(kD, activation + i * kLanes); });
    } else {
      HiddenArgument<kInputs>(shape, network.exponents.data(), j, samples, first + at, h);
      TanhOfPower<true>(h);
      Each<kVectors>([&](std::size_t i) HWY_ATTR { hn::StoreU(h[i], kD, activation + i * kLanes); });
    }
    const V weight = hn::Set(kD, v[j]);
    Each<kVectors>([&](std::size_t i) HWY_ATTR { error[i] = hn::NegMulAdd(weight, h[i], error[i]); });
    if (columns.slope == nullptr) continue;
    double* const slope = columns.slope + j * kStride + at;
    Each<kVectors>([&](std::size_t i) HWY_ATTR { h[i] = hn::NegMulAdd(h[i], h[i], hn::Set(kD, 1.0)); });
    if (columns.weighted) Each<kVectors>([&](std::size_t i) HWY_ATTR { h[i] = hn::Mul(weight, h[i]); });
    Each<kVectors>([&](std::size_t i) HWY_ATTR { hn::StoreU(h[i], kD, slope + i * kLanes); });
  }
  for (std::size_t c = 0; c < network.fixed.columns(); ++c) {
    const double* const column = network.fixed.column(c) + first + at;
    const V weight = hn::Set(kD, v[shape.hidden + 1 + c]);
    Each<kVectors>([&](std::size_t i) HWY_ATTR {
      error[i] = hn::NegMulAdd(weight, hn::LoadU(kD, column + i * kLanes), error[i]);
    });
  }
  if (columns.error == nullptr) return;
  Each<kVectors>([&](std::size_t i) HWY_ATTR { hn::StoreU(error[i], kD, columns.error + at + i * kLanes); });
}

// Fills the columns for `rows` rows from `first` on, with zeros in the padding.
template <bool kKept = false>
void HiddenBlock(const Network& network, const Samples& samples, std::size_t first, std::size_t rows,
                 const HiddenColumns& columns) {
  WithInputs(kKept ? 0 : network.shape.inputs, [&](auto inputs) HWY_ATTR {
    ForRows(rows, [&](std::size_t at, auto together) HWY_ATTR {
      HiddenRows<kKept, decltype(inputs)::value, decltype(together)::value>(network, samples, first, at,
                                                                            columns);
    });
  });
  const std::size_t real = samples.rows() - first;
  if (real >= rows) return;
  if (columns.error != nullptr) ClearPadding(columns.error, real, rows);
  for (std::size_t j = 0; j < network.shape.hidden; ++j) {
    ClearPadding(columns.activation + j * kStride, real, rows);
    if (columns.slope != nullptr) ClearPadding(columns.slope + j * kStride, real, rows);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_PERCEPTRON_KERNELS_INL
