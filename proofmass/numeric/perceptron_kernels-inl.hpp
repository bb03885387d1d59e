// SPDX-License-Identifier: Apache-2.0
// The mathematics of a block of samples, compiled once for every instruction set: included by
// perceptron_kernels.cpp alone, through foreach_target, so without an ordinary include guard.
//
// Operations of the multiplication ports a sample, for I inputs, H hidden units, n columns that the output is
// linear in (H + 1, and fixed ones) and p = H (I + 1) hidden weights, on 2 x 10 tiles; tanh takes T = 14,
// with AVX2 16:
//   activations, error    H (I + T + 1)
//   slopes                2 H
//   JᵀJ, Jᵀe, eᵀe         by slopes and products of inputs: I (I + 1) / 2 + H (H + 1) / 2 (1 + (I + 1) (I +
//   2) / 2)
//                         + p (H + 3) + (H + 2) (H + 3) / 2
//   q = phi T             n (n + 1) / 2
//   P = D - q C           p (n + 1) - H
//   PᵀP, Pᵀq, …, eᵀe      (p + n + 1) (p + n + 2) / 2
// 3-7-1: 126 for activations and error, 779 for the normal equations by all weights with them (a dense JᵀJ
// with Jᵀe and eᵀe alone would take 703), 1124 for those of variable projection.
#if defined(PROOFMASS_PERCEPTRON_KERNELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROOFMASS_PERCEPTRON_KERNELS_INL
#undef PROOFMASS_PERCEPTRON_KERNELS_INL
#else
#define PROOFMASS_PERCEPTRON_KERNELS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "proofmass/numeric/hyperbolic_tangent-inl.hpp"
#include "proofmass/numeric/perceptron_kernels.hpp"
#include "proofmass/numeric/product_sums-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

// A network whose output is linear in further columns: all its weights, those of the fixed columns last.
struct Network {
  const PerceptronShape& shape;
  const double* weights;
  const ColumnBlock& fixed;

  [[nodiscard]] const double* output() const { return weights + shape.hidden_weights(); }
};

// Calls body with the number of inputs as a constant where it is a usual one, so that loops over inputs
// unroll; otherwise with 0.
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

// Vectors of rows that go through a kernel together: enough that no step waits for the one before, and no
// more than the registers hold.
constexpr std::size_t kTogether = 4;
constexpr std::size_t kTogetherForward = HWY_TARGET <= HWY_AVX3 ? 6 : 4;

// Calls body with kMost for as many vectors of rows as there are, and with 1 for the rest.
template <std::size_t kMost = kTogether, typename Body>
HWY_INLINE void ForRows(std::size_t rows, const Body& body) {
  std::size_t row = 0;
  for (; row + kMost * kLanes <= rows; row += kMost * kLanes) {
    body(row, std::integral_constant<std::size_t, kMost>());
  }
  for (; row < rows; row += kLanes) body(row, std::integral_constant<std::size_t, 1>());
}

// z = weighted sum of the inputs of the rows from `row` on plus the bias, the argument of one hidden unit.
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

// What a pass keeps of a block of rows.
struct HiddenColumns {
  double* activation;  // one column a unit
  double* slope;       // v (1 - activation²), one column a unit; null where not wanted
  double* error;       // target less output
};

// Fills the columns for kVectors vectors of rows of a block, the first of them `at` within it and `first +
// at` within the samples.
template <std::size_t kInputs, std::size_t kVectors>
HWY_INLINE void HiddenRows(const Network& network, const Samples& samples, std::size_t first, std::size_t at,
                           const HiddenColumns& columns) {
  const PerceptronShape& shape = network.shape;
  const double* const v = network.output();
  V error[kVectors];
  Each<kVectors>([&](std::size_t i) HWY_ATTR {
    error[i] =
        hn::Sub(hn::LoadU(kD, samples.target_data() + first + at + i * kLanes), hn::Set(kD, v[shape.hidden]));
  });
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    V h[kVectors];
    HiddenArgument<kInputs>(shape, network.weights, j, samples, first + at, h);
    Tanh(h);
    const V weight = hn::Set(kD, v[j]);
    double* const activation = columns.activation + j * kStride + at;
    Each<kVectors>([&](std::size_t i) HWY_ATTR {
      hn::StoreU(h[i], kD, activation + i * kLanes);
      error[i] = hn::NegMulAdd(weight, h[i], error[i]);
    });
    if (columns.slope == nullptr) continue;
    double* const slope = columns.slope + j * kStride + at;
    Each<kVectors>([&](std::size_t i) HWY_ATTR {
      hn::StoreU(hn::Mul(weight, hn::NegMulAdd(h[i], h[i], hn::Set(kD, 1.0))), kD, slope + i * kLanes);
    });
  }
  for (std::size_t c = 0; c < network.fixed.columns(); ++c) {
    const double* const column = network.fixed.column(c) + first + at;
    const V weight = hn::Set(kD, v[shape.hidden + 1 + c]);
    Each<kVectors>([&](std::size_t i) HWY_ATTR {
      error[i] = hn::NegMulAdd(weight, hn::LoadU(kD, column + i * kLanes), error[i]);
    });
  }
  Each<kVectors>([&](std::size_t i) HWY_ATTR { hn::StoreU(error[i], kD, columns.error + at + i * kLanes); });
}

// Fills the columns for `rows` rows from `first` on, zero in the padding.
void HiddenBlock(const Network& network, const Samples& samples, std::size_t first, std::size_t rows,
                 const HiddenColumns& columns) {
  WithInputs(network.shape.inputs, [&](auto inputs) HWY_ATTR {
    ForRows(rows, [&](std::size_t at, auto together) HWY_ATTR {
      HiddenRows<decltype(inputs)::value, decltype(together)::value>(network, samples, first, at, columns);
    });
  });
  const std::size_t real = samples.rows() - first;
  if (real >= rows) return;
  ClearPadding(columns.error, real, rows);
  for (std::size_t j = 0; j < network.shape.hidden; ++j) {
    ClearPadding(columns.activation + j * kStride, real, rows);
    if (columns.slope != nullptr) ClearPadding(columns.slope + j * kStride, real, rows);
  }
}

// Products of the inputs two and two, each input taken last being one: x_1 x_1, x_1 x_2, … x_1, x_2 x_2, …
// x_I, 1.
void MomentBlock(const Samples& samples, std::size_t first, std::size_t rows, double* moments) {
  for (std::size_t k = 0; k < samples.inputs(); ++k) {
    const double* const x = samples.input_data(k) + first;
    for (std::size_t l = k; l < samples.inputs(); ++l, moments += kStride) {
      const double* const y = samples.input_data(l) + first;
      for (std::size_t at = 0; at < rows; at += kLanes) {
        hn::StoreU(hn::Mul(hn::LoadU(kD, x + at), hn::LoadU(kD, y + at)), kD, moments + at);
      }
    }
    std::copy_n(x, rows, moments);
    moments += kStride;
  }
  std::copy_n(samples.mask_data() + first, rows, moments);
}

// q = phi * transform (upper triangular).
void TransformBlock(const double* const* phi, const Matrix& transform, std::size_t rows, double* q) {
  for (std::size_t c = 0; c < transform.columns(); ++c, q += kStride) {
    ForRows(rows, [&](std::size_t at, auto together) HWY_ATTR {
      constexpr std::size_t kVectors = decltype(together)::value;
      V sums[kVectors];
      Each<kVectors>([&](std::size_t i) HWY_ATTR { sums[i] = hn::Zero(kD); });
      for (std::size_t r = 0; r <= c; ++r) {
        const V factor = hn::Set(kD, transform(r, c));
        const double* const column = phi[r] + at;
        Each<kVectors>([&](std::size_t i) HWY_ATTR {
          sums[i] = hn::MulAdd(factor, hn::LoadU(kD, column + i * kLanes), sums[i]);
        });
      }
      Each<kVectors>([&](std::size_t i) HWY_ATTR { hn::StoreU(sums[i], kD, q + at + i * kLanes); });
    });
  }
}

// kColumns columns of P = D - q * projection, number c[0] … of all: those of inputs[0] … of one unit, null
// for its bias, for kVectors vectors of rows.
template <std::size_t kColumns, std::size_t kVectors>
HWY_INLINE void ProjectRows(const double* slope, const double* const* inputs, const double* q,
                            const Matrix& projection, const std::size_t* c, std::size_t at, double* p) {
  V sums[kColumns][kVectors];
  Each<kColumns>([&](std::size_t k) HWY_ATTR {
    Each<kVectors>([&](std::size_t i) HWY_ATTR {
      const V s = hn::LoadU(kD, slope + at + i * kLanes);
      sums[k][i] = inputs[k] == nullptr ? s : hn::Mul(s, hn::LoadU(kD, inputs[k] + at + i * kLanes));
    });
  });
  for (std::size_t r = 0; r < projection.rows(); ++r, q += kStride) {
    V values[kVectors];
    Each<kVectors>([&](std::size_t i)
                       HWY_ATTR { values[i] = InRegister(hn::LoadU(kD, q + at + i * kLanes)); });
    Each<kColumns>([&](std::size_t k) HWY_ATTR {
      const V factor = hn::Set(kD, projection(r, c[k]));
      Each<kVectors>([&](std::size_t i)
                         HWY_ATTR { sums[k][i] = hn::NegMulAdd(factor, values[i], sums[k][i]); });
    });
  }
  Each<kColumns>([&](std::size_t k) HWY_ATTR {
    Each<kVectors>([&](std::size_t i)
                       HWY_ATTR { hn::StoreU(sums[k][i], kD, p + c[k] * kStride + at + i * kLanes); });
  });
}

// P = D - q * projection, columns in the order of the hidden weights.
void ProjectBlock(const PerceptronShape& shape, const Samples& samples, std::size_t first, std::size_t rows,
                  const double* slopes, const double* q, const Matrix& projection, double* p) {
  std::vector<const double*> inputs(shape.inputs + 1, nullptr);
  for (std::size_t k = 0; k < shape.inputs; ++k) inputs[k] = samples.input_data(k) + first;
  std::vector<std::size_t> columns(shape.inputs + 1);
  for (std::size_t j = 0; j < shape.hidden; ++j, slopes += kStride) {
    for (std::size_t k = 0; k < shape.inputs; ++k) columns[k] = j * shape.inputs + k;
    columns[shape.inputs] = shape.hidden * shape.inputs + j;
    std::size_t k = 0;
    for (; k + 2 <= columns.size(); k += 2) {
      ForRows(rows, [&](std::size_t at, auto together) HWY_ATTR {
        ProjectRows<2, decltype(together)::value>(slopes, &inputs[k], q, projection, &columns[k], at, p);
      });
    }
    if (k == columns.size()) continue;
    ForRows(rows, [&](std::size_t at, auto together) HWY_ATTR {
      ProjectRows<1, decltype(together)::value>(slopes, &inputs[k], q, projection, &columns[k], at, p);
    });
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_PERCEPTRON_KERNELS_INL
