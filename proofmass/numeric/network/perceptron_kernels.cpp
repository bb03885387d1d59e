// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/network/perceptron_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "proofmass/numeric/network/perceptron_kernels.cpp"
#include <hwy/foreach_target.h>
// foreach_target includes this file once for every instruction set; the next header must come after it.
#include "proofmass/numeric/network/perceptron_normal_sums-inl.hpp"

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
HWY_INLINE void OutputRows(const Network& network, const Samples& samples, std::size_t row,
                           V (&output)[kVectors]) {
  const std::size_t hidden = network.shape.hidden;
  Each<kVectors>([&](std::size_t i) HWY_ATTR { output[i] = hn::Set(kD, network.output[hidden]); });
  for (std::size_t j = 0; j < hidden; ++j) {
    V h[kVectors];
    HiddenArgument<kInputs>(network.shape, network.exponents.data(), j, samples, row, h);
    TanhOfPower<false>(h);
    const V weight = hn::Set(kD, network.output[j]);
    Each<kVectors>([&](std::size_t i) HWY_ATTR { output[i] = hn::MulAdd(weight, h[i], output[i]); });
  }
}

// Returns the sum of squared errors; stores the outputs unless the pointer is null.
double Forward(const PerceptronShape& shape, const double* weights, const Samples& samples, double* outputs) {
  V sums = hn::Zero(kD);
  const Network network{shape, weights, kNoColumns};
  WithInputs(shape.inputs, [&](auto inputs) HWY_ATTR {
    ForRows<kTogetherForward>(samples.padded_rows(), [&](std::size_t row, auto together) HWY_ATTR {
      constexpr std::size_t kVectors = decltype(together)::value;
      V output[kVectors];
      OutputRows<decltype(inputs)::value>(network, samples, row, output);
      Each<kVectors>([&](std::size_t i) HWY_ATTR {
        const std::size_t at = row + i * kLanes;
        if (outputs != nullptr) hn::StoreU(output[i], kD, outputs + at);
        const V error = hn::Sub(hn::LoadU(kD, samples.target_data() + at), output[i]);
        const V real = hn::Mul(hn::LoadU(kD, samples.mask_data() + at), error);
        sums = hn::MulAdd(real, real, sums);
      });
    });
  });
  return hn::GetLane(hn::SumOfLanes(kD, sums));
}

void Activations(const PerceptronShape& shape, const double* weights, const Samples& samples,
                 ColumnBlock& phi) {
  const Network network{shape, weights, kNoColumns};
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    ForRows(samples.padded_rows(), [&](std::size_t row, auto together) HWY_ATTR {
      constexpr std::size_t kVectors = decltype(together)::value;
      V h[kVectors];
      HiddenArgument<0>(shape, network.exponents.data(), j, samples, row, h);
      TanhOfPower<true>(h);
      Each<kVectors>([&](std::size_t i) HWY_ATTR { hn::StoreU(h[i], kD, phi.column(j) + row + i * kLanes); });
    });
    ClearPadding(phi.column(j), samples.rows(), samples.padded_rows());
  }
}

double NormalEquations(const PerceptronShape& shape, const double* weights, const Samples& samples, bool kept,
                       PerceptronColumns& columns, Matrix& jtj, double* jte) {
  const Network network{shape, weights, kNoColumns};
  NormalSums sums(network, samples, columns);
  sums.run(kept);
  return sums.store(jtj, jte);
}

const char* Target() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace proofmass {

HWY_EXPORT(TanhOf);
HWY_EXPORT(Forward);
HWY_EXPORT(KeepingForward);
HWY_EXPORT(Activations);
HWY_EXPORT(NormalEquations);
HWY_EXPORT(Target);

void perceptron_outputs(const PerceptronShape& shape, std::span<const double> weights, const Samples& samples,
                        std::span<double> outputs) {
  AlignedColumn padded(samples.padded_rows());
  HWY_DYNAMIC_DISPATCH(Forward)(shape, weights.data(), samples, padded.data());
  std::copy_n(padded.begin(), samples.rows(), outputs.begin());
}

double perceptron_sse(const PerceptronShape& shape, std::span<const double> weights, const Samples& samples) {
  return HWY_DYNAMIC_DISPATCH(Forward)(shape, weights.data(), samples, nullptr);
}

double perceptron_sse(const PerceptronShape& shape, std::span<const double> weights, const Samples& samples,
                      PerceptronColumns& columns) {
  if (!columns.hidden.keeps()) return perceptron_sse(shape, weights, samples);
  return HWY_DYNAMIC_DISPATCH(KeepingForward)(shape, weights.data(), samples, columns.hidden);
}

double perceptron_normal_equations(const PerceptronShape& shape, std::span<const double> weights,
                                   const Samples& samples, bool kept, PerceptronColumns& columns, Matrix& jtj,
                                   std::span<double> jte) {
  return HWY_DYNAMIC_DISPATCH(NormalEquations)(shape, weights.data(), samples, kept, columns, jtj,
                                               jte.data());
}

void hidden_activations(const PerceptronShape& shape, std::span<const double> hidden_weights,
                        const Samples& samples, ColumnBlock& phi) {
  HWY_DYNAMIC_DISPATCH(Activations)(shape, hidden_weights.data(), samples, phi);
}

void tanh_of(std::span<const double> z, std::span<double> result) {
  HWY_DYNAMIC_DISPATCH(TanhOf)(z.data(), z.size(), result.data());
}

const char* kernel_target() { return HWY_DYNAMIC_DISPATCH(Target)(); }

}  // namespace proofmass
#endif  // HWY_ONCE
