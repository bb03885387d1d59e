// SPDX-License-Identifier: Apache-2.0
// tanh of a vector, compiled once for every instruction set. The file is included through foreach_target, so
// it has no ordinary include guard. A fine value (see below), whose argument was scaled before, takes 12
// operations of the multiplication ports, fused ones counted once (with AVX-512 and its table 8, and two
// permutations), two bounds, a shift and one division. Additions have ports of their own. A value that is not
// fine takes one multiplication less, and a permutation.
#if defined(PROOFMASS_HYPERBOLIC_TANGENT_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROOFMASS_HYPERBOLIC_TANGENT_INL
#undef PROOFMASS_HYPERBOLIC_TANGENT_INL
#else
#define PROOFMASS_HYPERBOLIC_TANGENT_INL
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "proofmass/numeric/simd/vector_type-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The fractional part of the exponent has 16 steps; a polynomial gives 2^r - 1 for the remainder r of a step.
#if HWY_TARGET <= HWY_AVX3
constexpr int kFractionBits = 4;  // 16 steps, held in two registers

// 2^(i/16), with i subtracted from the lowest bits of its exponent in advance, because the integer addition
// below adds it.
HWY_INLINE V FractionPower(hn::Vec<hn::RebindToUnsigned<D>> bits) {
  alignas(64) static constexpr std::uint64_t kPower[16] = {
      0x3ff0000000000000, 0x3fefb5586cf9890f, 0x3fef72b83c7d517b, 0x3fef387a6e756238,
      0x3fef06fe0a31b715, 0x3feedea64c123422, 0x3feebfdad5362a27, 0x3feeab07dd485429,
      0x3feea09e667f3bcd, 0x3feea11473eb0187, 0x3feeace5422aa0db, 0x3feec49182a3f090,
      0x3feee89f995ad3ad, 0x3fef199bdd85529c, 0x3fef5818dcfba487, 0x3fefa4afa2a490da};
  const hn::RebindToUnsigned<D> du;
  const V low = hn::BitCast(kD, hn::Load(du, kPower));
  const V high = hn::BitCast(kD, hn::Load(du, kPower + 8));
  return V{_mm512_permutex2var_pd(low.raw, bits.raw, high.raw)};
}

// The relative rounding errors of those powers.
HWY_INLINE V FractionRemainder(hn::Vec<hn::RebindToUnsigned<D>> bits) {
  alignas(64) static constexpr double kRemainder[16] = {0.0,
                                                        8.189317638195515e-17,
                                                        -2.7939114859515733e-17,
                                                        7.826573258636076e-17,
                                                        3.3484623336251524e-17,
                                                        3.750854201303127e-17,
                                                        1.9572585293112036e-17,
                                                        5.68648095791174e-17,
                                                        -6.835808657661922e-17,
                                                        -2.3591094770850053e-17,
                                                        5.1548301170786783e-17,
                                                        1.5341410053603723e-17,
                                                        4.875160526227062e-17,
                                                        1.685487290628973e-17,
                                                        1.790126907604513e-17,
                                                        -5.545065618639427e-17};
  const V low = hn::Load(kD, kRemainder);
  const V high = hn::Load(kD, kRemainder + 8);
  return V{_mm512_permutex2var_pd(low.raw, bits.raw, high.raw)};
}
#else
constexpr int kFractionBits = 0;
#endif

// One step of a computation on several vectors. Each step is done for all vectors, so that no step waits for
// the one before.
template <std::size_t kVectors, typename Step>
HWY_INLINE void Each(const Step& step) {
#pragma GCC unroll 8
  for (std::size_t i = 0; i < kVectors; ++i) step(i);
}

// Coefficients of (2^r - 1) / r for |r| <= 2^-(kFractionBits + 1), the highest first, by Chebyshev
// interpolation. Relative error 5e-17, with one coefficient less 1.5e-15.
#if HWY_TARGET <= HWY_AVX3
inline constexpr std::array kFineCoefficients{
    1.5252907746886827e-05, 0.0001540375624545771, 0.0013333558145579112, 0.009618129106525682,
    0.05550410866482159,    0.24022650695910086,   0.6931471805599453};
inline constexpr std::array kCoarseCoefficients{0.00015403723980749256, 0.0013333781576784268,
                                                0.009618129106919537,   0.0555041086566393,
                                                0.24022650695910075,    0.6931471805599457};
#else
inline constexpr std::array kFineCoefficients{
    4.4549605981865186e-10, 7.072585949269223e-09, 1.0178062445845774e-07, 1.321544258792169e-06,
    1.525273382983612e-05,  0.0001540353044173605, 0.0013333558146416936,  0.009618129107606888,
    0.0555041086648216,     0.24022650695910097,   0.6931471805599453};
inline constexpr std::array kCoarseCoefficients{
    7.070977866508138e-09,  1.0205905413765595e-07, 1.3215451633221434e-06, 1.5252672924850737e-05,
    0.00015403530424776529, 0.0013333558200794592,  0.009618129107618665,   0.05550410866465167,
    0.24022650695910075,    0.6931471805599462};
#endif

// 2^r - 1 by these coefficients, in place.
template <std::size_t kCoefficients, std::size_t kVectors>
HWY_INLINE void PowerLessOne(const std::array<double, kCoefficients>& coefficients, V (&r)[kVectors]) {
  V p[kVectors];
  Each<kVectors>([&](std::size_t i) HWY_ATTR { p[i] = hn::Set(kD, coefficients[0]); });
  for (std::size_t k = 1; k < kCoefficients; ++k) {
    const V next = hn::Set(kD, coefficients[k]);
    Each<kVectors>([&](std::size_t i) HWY_ATTR { p[i] = hn::MulAdd(p[i], r[i], next); });
  }
  Each<kVectors>([&](std::size_t i) HWY_ATTR { r[i] = hn::Mul(p[i], r[i]); });
}

// tanh of half the natural logarithm of 2^u, in place: m / (m + 2) with m = 2^u - 1, the table's power times
// the polynomial. Fine: accurate to a few units in the last place for every u, because the last digits of
// training depend on it. Otherwise the error is 4e-16 absolute, which is equally good near one, and 4.5e-15
// relative.
template <bool kFine, std::size_t kVectors>
HWY_INLINE void TanhOfPower(V (&u)[kVectors]) {
  const auto constant = [](double c) HWY_ATTR { return hn::Set(kD, c); };
  const hn::RebindToUnsigned<D> du;
  // Adding 1.5 * 2^52 leaves u, rounded to a step, in the low bits of the sum.
  const V magic = InRegister(constant(6755399441055744.0 / (1 << kFractionBits)));
  V r[kVectors], shifted[kVectors], scale[kVectors];
  Each<kVectors>([&](std::size_t i) HWY_ATTR { r[i] = hn::Max(constant(-60.0), u[i]); });
  Each<kVectors>([&](std::size_t i) HWY_ATTR { r[i] = hn::Min(constant(60.0), r[i]); });
  Each<kVectors>([&](std::size_t i) HWY_ATTR { shifted[i] = hn::Add(r[i], magic); });
  Each<kVectors>([&](std::size_t i) HWY_ATTR { r[i] = hn::Sub(r[i], hn::Sub(shifted[i], magic)); });
  if constexpr (kFine) {
    PowerLessOne(kFineCoefficients, r);
  } else {
    PowerLessOne(kCoarseCoefficients, r);
  }
  Each<kVectors>([&](std::size_t i) HWY_ATTR {
    const auto bits = hn::BitCast(du, shifted[i]);
#if HWY_TARGET <= HWY_AVX3
    if constexpr (kFine) r[i] = hn::Add(r[i], FractionRemainder(hn::BitCast(du, After(r[i], shifted[i]))));
    const auto fraction = hn::BitCast(du, FractionPower(bits));
#else
    const auto fraction = hn::BitCast(du, constant(1.0));
#endif
    scale[i] = hn::BitCast(kD, hn::Add(fraction, hn::ShiftLeft<52 - kFractionBits>(bits)));
  });
  Each<kVectors>([&](std::size_t i)
                     HWY_ATTR { r[i] = hn::MulAdd(scale[i], r[i], hn::Sub(scale[i], constant(1.0))); });
  Each<kVectors>([&](std::size_t i) HWY_ATTR {
    const V tanh = hn::Div(r[i], hn::Add(r[i], constant(2.0)));
    // Min and Max return a second operand that is NaN, except where Highway emulates them.
    constexpr bool kEmulated = HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128;
    u[i] = kEmulated ? hn::IfThenElse(hn::IsNaN(u[i]), u[i], tanh) : tanh;
  });
}

// The factor of z in tanh z that makes it an exponent of two: 2 / ln 2.
constexpr double kPowerOfTwo = 2.8853900817779268;

// tanh, in place.
template <std::size_t kVectors>
HWY_INLINE void Tanh(V (&z)[kVectors]) {
  Each<kVectors>([&](std::size_t i) HWY_ATTR { z[i] = hn::Mul(z[i], hn::Set(kD, kPowerOfTwo)); });
  TanhOfPower<true>(z);
}

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_HYPERBOLIC_TANGENT_INL
