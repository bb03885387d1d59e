// SPDX-License-Identifier: Apache-2.0
#include "limits/kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "limits/kernels.cpp"
#include <hwy/foreach_target.h>
// foreach_target includes this file once for every instruction set; these must come after it.
#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace bench {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
constexpr D kD;
constexpr std::size_t kChains = 12;  // independent; more than latency times ports
constexpr std::size_t kSteps = 4096;

// Applies `operation` to kChains chains, kSteps times each. Returns a value that depends on all of them.
template <typename Operation>
double Chains(double x, const Operation& operation) {
  const V first = hn::Iota(kD, x);
  const auto start = [&](double offset) { return hn::Add(first, hn::Set(kD, offset)); };
  V a = start(0.1), b = start(0.2), c = start(0.3), d = start(0.4), e = start(0.5), f = start(0.6);
  V g = start(0.7), h = start(0.8), i = start(0.9), j = start(1.0), k = start(1.1), l = start(1.2);
  for (std::size_t step = 0; step < kSteps; ++step) {
    a = operation(a), b = operation(b), c = operation(c), d = operation(d);
    e = operation(e), f = operation(f), g = operation(g), h = operation(h);
    i = operation(i), j = operation(j), k = operation(k), l = operation(l);
  }
  const V sum = hn::Add(hn::Add(hn::Add(a, b), hn::Add(c, d)), hn::Add(hn::Add(e, f), hn::Add(g, h)));
  return hn::GetLane(hn::SumOfLanes(kD, hn::Add(sum, hn::Add(hn::Add(i, j), hn::Add(k, l)))));
}

double Fma(double x) {
  const V m = hn::Set(kD, x), n = hn::Set(kD, 1.0 - x);
  return Chains(x, [=](V v) { return hn::MulAdd(v, m, n); });
}
double Add(double x) {
  const V n = hn::Set(kD, x);
  return Chains(x, [=](V v) { return hn::Add(v, n); });
}
double Min(double x) {
  const V n = hn::Set(kD, x);
  return Chains(x, [=](V v) { return hn::Min(v, n); });
}
double Divide(double x) {
  const V n = hn::Set(kD, x);
  return Chains(x, [=](V v) { return hn::Div(n, v); });
}
// The compiler does not know that the order stays the same.
double Permute(double x) {
  const auto indices =
      hn::IndicesFromVec(kD, hn::Iota(hn::RebindToSigned<D>(), static_cast<std::int64_t>(x) - 1));
  return Chains(x, [=](V v) { return hn::TableLookupLanes(v, indices); });
}

// Sums a buffer that stays in the first-level cache.
double Load(const double* HWY_RESTRICT data) {
  V a = hn::Zero(kD), b = a, c = a, d = a;
  for (std::size_t repeat = 0; repeat < kLoadRepeats; ++repeat) {
    for (std::size_t k = 0; k < kLoadDoubles; k += 4 * hn::Lanes(kD)) {
      a = hn::Add(a, hn::LoadU(kD, data + k));
      b = hn::Add(b, hn::LoadU(kD, data + k + hn::Lanes(kD)));
      c = hn::Add(c, hn::LoadU(kD, data + k + 2 * hn::Lanes(kD)));
      d = hn::Add(d, hn::LoadU(kD, data + k + 3 * hn::Lanes(kD)));
    }
  }
  return hn::GetLane(hn::SumOfLanes(kD, hn::Add(hn::Add(a, b), hn::Add(c, d))));
}

void HighwayTanh(const double* HWY_RESTRICT z, std::size_t n, double* HWY_RESTRICT result) {
  for (std::size_t k = 0; k < n; k += hn::Lanes(kD)) {
    hn::StoreU(hn::Tanh(kD, hn::LoadU(kD, z + k)), kD, result + k);
  }
}

std::size_t LaneCount() { return hn::Lanes(kD); }
std::size_t Operations() { return kChains * kSteps; }
const char* Name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bench {

HWY_EXPORT(Fma);
HWY_EXPORT(Add);
HWY_EXPORT(Min);
HWY_EXPORT(Divide);
HWY_EXPORT(Permute);
HWY_EXPORT(Load);
HWY_EXPORT(HighwayTanh);
HWY_EXPORT(LaneCount);
HWY_EXPORT(Name);
HWY_EXPORT(Operations);

Kernels kernels() {
  return {.target = HWY_DYNAMIC_DISPATCH(Name)(),
          .lanes = HWY_DYNAMIC_DISPATCH(LaneCount)(),
          .operations = HWY_DYNAMIC_DISPATCH(Operations)(),
          .fma = [] { return HWY_DYNAMIC_DISPATCH(Fma)(0.999); },
          .add = [] { return HWY_DYNAMIC_DISPATCH(Add)(0.001); },
          .min = [] { return HWY_DYNAMIC_DISPATCH(Min)(3.0); },
          .divide = [] { return HWY_DYNAMIC_DISPATCH(Divide)(3.0); },
          .permute = [] { return HWY_DYNAMIC_DISPATCH(Permute)(1.0); },
          .load = [](const double* data) { return HWY_DYNAMIC_DISPATCH(Load)(data); },
          .highway_tanh =
              [](const double* z, std::size_t n, double* result) {
                HWY_DYNAMIC_DISPATCH(HighwayTanh)
                (z, n, result);
              }};
}

}  // namespace bench
#endif  // HWY_ONCE
