// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/perceptron_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "proofmass/numeric/perceptron_kernels.cpp"
#include <hwy/foreach_target.h>
// foreach_target includes this file once for every instruction set; the next header must come after it.
#include "proofmass/numeric/perceptron_products-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

void TanhOf(const double* z, std::size_t size, double* result) {
  const std::size_t whole = size / kLanes * kLanes;
  ForRows(whole, [&](std::size_t at, auto together) HWY_ATTR {
    constexpr std::size_t kVectors = decltype(together)::value;
    V values[kVectors];
    Each<kVectors>([&](std::size_t i) HWY_ATTR { values[i] = hn::LoadU(kD, z + at + i * kLanes); });
    Tanh(values);
    Each<kVectors>([&](std::size_t i) HWY_ATTR { hn::StoreU(values[i], kD, result + at + i * kLanes); });
  });
  if (whole == size) return;
  HWY_ALIGN double rest[kLanes] = {};
  std::copy(z + whole, z + size, rest);
  V values[1] = {hn::Load(kD, rest)};
  Tanh(values);
  hn::Store(values[0], kD, rest);
  std::copy(rest, rest + (size - whole), result + whole);
}

// The outputs of kVectors vectors of rows from `row` on.
template <std::size_t kInputs, std::size_t kVectors>
HWY_INLINE void OutputRows(const PerceptronShape& shape, const double* weights, const Samples& samples,
                           std::size_t row, V (&output)[kVectors]) {
  const double* const v = weights + shape.hidden_weights();
  Each<kVectors>([&](std::size_t i) HWY_ATTR { output[i] = hn::Set(kD, v[shape.hidden]); });
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    V h[kVectors];
    HiddenArgument<kInputs>(shape, weights, j, samples, row, h);
    Tanh(h);
    const V weight = hn::Set(kD, v[j]);
    Each<kVectors>([&](std::size_t i) HWY_ATTR { output[i] = hn::MulAdd(weight, h[i], output[i]); });
  }
}

// Returns the sum of squared errors; stores the outputs unless null.
double Forward(const PerceptronShape& shape, const double* weights, const Samples& samples, double* outputs) {
  V sums = hn::Zero(kD);
  WithInputs(shape.inputs, [&](auto inputs) HWY_ATTR {
    ForRows(samples.padded_rows(), [&](std::size_t row, auto together) HWY_ATTR {
      constexpr std::size_t kVectors = decltype(together)::value;
      V output[kVectors];
      OutputRows<decltype(inputs)::value>(shape, weights, samples, row, output);
      for (std::size_t i = 0; i < kVectors; ++i) {
        const std::size_t at = row + i * kLanes;
        if (outputs != nullptr) hn::StoreU(output[i], kD, outputs + at);
        const V error = hn::Sub(hn::LoadU(kD, samples.target_data() + at), output[i]);
        const V real = hn::Mul(hn::LoadU(kD, samples.mask_data() + at), error);
        sums = hn::MulAdd(real, real, sums);
      }
    });
  });
  return hn::GetLane(hn::SumOfLanes(kD, sums));
}

void Activations(const PerceptronShape& shape, const double* weights, const Samples& samples,
                 ColumnBlock& phi) {
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    ForRows(samples.padded_rows(), [&](std::size_t row, auto together) HWY_ATTR {
      constexpr std::size_t kVectors = decltype(together)::value;
      V h[kVectors];
      HiddenArgument<0>(shape, weights, j, samples, row, h);
      Tanh(h);
      Each<kVectors>([&](std::size_t i) HWY_ATTR { hn::StoreU(h[i], kD, phi.column(j) + row + i * kLanes); });
    });
    ClearPadding(phi.column(j), samples.rows(), samples.padded_rows());
  }
}

void SumProducts(const PerceptronShape& shape, const double* weights, const Samples& samples,
                 const ColumnBlock& fixed, const Matrix* transform, bool derivatives,
                 PerceptronProducts& products) {
  const Network network{shape, weights, fixed};
  Products pass(network, samples, transform, derivatives);
  pass.run();
  pass.store(products);
}

// Second derivative of the output along `direction`, for the block of rows from `first` on: a unit with
// argument z and dz along the direction gives 2 dz (dv (1 - h²) - slope h dz).
template <std::size_t kInputs>
void SecondDerivative(const Network& network, const double* direction, const Samples& samples,
                      std::size_t first, std::size_t rows, const HiddenColumns& columns, double* second) {
  const double* const dv = direction + network.shape.hidden_weights();
  ForRows(rows, [&](std::size_t at, auto together) HWY_ATTR {
    constexpr std::size_t kVectors = decltype(together)::value;
    V sum[kVectors];
    Each<kVectors>([&](std::size_t i) HWY_ATTR { sum[i] = hn::Zero(kD); });
    for (std::size_t j = 0; j < network.shape.hidden; ++j) {
      V dz[kVectors];
      HiddenArgument<kInputs>(network.shape, direction, j, samples, first + at, dz);
      Each<kVectors>([&](std::size_t i) HWY_ATTR {
        const V h = hn::LoadU(kD, columns.activation + j * kStride + at + i * kLanes);
        const V slope = hn::LoadU(kD, columns.slope + j * kStride + at + i * kLanes);
        const V rate = hn::Mul(hn::Set(kD, dv[j]), hn::NegMulAdd(h, h, hn::Set(kD, 1.0)));
        sum[i] = hn::MulAdd(dz[i], hn::NegMulAdd(hn::Mul(slope, h), dz[i], rate), sum[i]);
      });
    }
    Each<kVectors>([&](std::size_t i)
                       HWY_ATTR { hn::StoreU(hn::Add(sum[i], sum[i]), kD, second + at + i * kLanes); });
  });
  ClearPadding(second, samples.rows() - first, rows);
}

// Columns of a block: activations, ones, fixed columns; slopes; error; second derivative; inputs and one.
void Curvature(const PerceptronShape& shape, const double* weights, const double* direction,
               const Samples& samples, const ColumnBlock& fixed, double* d_second, double* phi_second) {
  const Network network{shape, weights, fixed};
  const std::size_t hidden = shape.hidden;
  const std::size_t n = shape.output_weights() + fixed.columns();
  ProductSums by_weight(hidden, shape.inputs + 1, false), by_output(1, n, false);
  const std::size_t sums = by_weight.storage() + by_output.storage();
  double* const storage = kernel_scratch(sums + (n + hidden + shape.inputs + 3) * kStride);
  std::fill_n(storage, sums, 0.0);
  by_weight.start(storage);
  by_output.start(storage + by_weight.storage());
  double* const phi = storage + sums;
  double* const slope = phi + n * kStride;
  double* const error = slope + hidden * kStride;
  double* const second = error + kStride;
  double* const inputs = second + kStride;
  for (std::size_t j = 0; j < hidden; ++j) by_weight.left[j] = {second, slope + j * kStride};
  by_weight.right = inputs;
  by_output.right = phi;
  for (std::size_t first = 0; first < samples.padded_rows(); first += kBlockRows) {
    const std::size_t rows = std::min(kBlockRows, samples.padded_rows() - first);
    const double* const ones = samples.mask_data() + first;
    const HiddenColumns columns{.activation = phi, .slope = slope, .error = error};
    HiddenBlock(network, samples, first, rows, columns);
    WithInputs(shape.inputs, [&](auto count) HWY_ATTR {
      SecondDerivative<decltype(count)::value>(network, direction, samples, first, rows, columns, second);
    });
    std::copy_n(ones, rows, phi + hidden * kStride);
    for (std::size_t c = 0; c < fixed.columns(); ++c) {
      std::copy_n(fixed.column(c) + first, rows, phi + (hidden + 1 + c) * kStride);
    }
    for (std::size_t k = 0; k < shape.inputs; ++k) {
      std::copy_n(samples.input_data(k) + first, rows, inputs + k * kStride);
    }
    std::copy_n(ones, rows, inputs + shape.inputs * kStride);
    by_output.left[0] = {second, ones};
    by_weight.add(rows);
    by_output.add(rows);
  }
  by_weight.finish();
  by_output.finish();
  for (std::size_t j = 0; j < hidden; ++j) {
    for (std::size_t k = 0; k < shape.inputs; ++k) d_second[j * shape.inputs + k] = by_weight.total(j, k);
    d_second[hidden * shape.inputs + j] = by_weight.total(j, shape.inputs);
  }
  for (std::size_t c = 0; c < n; ++c) phi_second[c] = by_output.total(0, c);
}

const char* Target() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace proofmass {

HWY_EXPORT(TanhOf);
HWY_EXPORT(Forward);
HWY_EXPORT(Activations);
HWY_EXPORT(SumProducts);
HWY_EXPORT(Curvature);
HWY_EXPORT(Target);

double* kernel_scratch(std::size_t size) {
  thread_local AlignedColumn storage;
  if (storage.size() < size) storage.resize(size);
  return storage.data();
}

void perceptron_outputs(const PerceptronShape& shape, std::span<const double> weights, const Samples& samples,
                        std::span<double> outputs) {
  AlignedColumn padded(samples.padded_rows());
  HWY_DYNAMIC_DISPATCH(Forward)(shape, weights.data(), samples, padded.data());
  std::copy_n(padded.begin(), samples.rows(), outputs.begin());
}

double perceptron_sse(const PerceptronShape& shape, std::span<const double> weights, const Samples& samples) {
  return HWY_DYNAMIC_DISPATCH(Forward)(shape, weights.data(), samples, nullptr);
}

double perceptron_normal_equations(const PerceptronShape& shape, std::span<const double> weights,
                                   const Samples& samples, Matrix& jtj, std::span<double> jte) {
  const std::size_t p = shape.hidden_weights();
  const std::size_t n = shape.output_weights();
  PerceptronProducts products(shape, 0);
  HWY_DYNAMIC_DISPATCH(SumProducts)(shape, weights.data(), samples, {}, nullptr, true, products);
  for (std::size_t c = 0; c < p; ++c) std::copy_n(products.dd.column(c).begin(), p, jtj.column(c).begin());
  for (std::size_t c = 0; c < n; ++c) {
    for (std::size_t r = 0; r < p; ++r) jtj(r, p + c) = jtj(p + c, r) = products.dq(r, c);
    std::copy_n(products.qq.column(c).begin(), n, jtj.column(p + c).begin() + static_cast<std::ptrdiff_t>(p));
  }
  std::copy(products.de.begin(), products.de.end(), jte.begin());
  std::copy(products.qe.begin(), products.qe.end(), jte.begin() + static_cast<std::ptrdiff_t>(p));
  return products.ee;
}

void hidden_activations(const PerceptronShape& shape, std::span<const double> hidden_weights,
                        const Samples& samples, ColumnBlock& phi) {
  HWY_DYNAMIC_DISPATCH(Activations)(shape, hidden_weights.data(), samples, phi);
}

void perceptron_products(const PerceptronShape& shape, std::span<const double> weights,
                         const Samples& samples, const ColumnBlock& fixed, const Matrix& transform,
                         bool derivatives, PerceptronProducts& products) {
  HWY_DYNAMIC_DISPATCH(SumProducts)
  (shape, weights.data(), samples, fixed, &transform, derivatives, products);
}

void perceptron_curvature(const PerceptronShape& shape, std::span<const double> weights,
                          std::span<const double> direction, const Samples& samples, const ColumnBlock& fixed,
                          std::span<double> d_second, std::span<double> phi_second) {
  HWY_DYNAMIC_DISPATCH(Curvature)
  (shape, weights.data(), direction.data(), samples, fixed, d_second.data(), phi_second.data());
}

void tanh_of(std::span<const double> z, std::span<double> result) {
  HWY_DYNAMIC_DISPATCH(TanhOf)(z.data(), z.size(), result.data());
}

const char* kernel_target() { return HWY_DYNAMIC_DISPATCH(Target)(); }

}  // namespace proofmass
#endif  // HWY_ONCE
