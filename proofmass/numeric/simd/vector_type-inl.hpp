// SPDX-License-Identifier: Apache-2.0
// The vector that kernels over samples compute with, for every instruction set: included through
// foreach_target, so without an ordinary include guard.
#if defined(PROOFMASS_VECTOR_TYPE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROOFMASS_VECTOR_TYPE_INL
#undef PROOFMASS_VECTOR_TYPE_INL
#else
#define PROOFMASS_VECTOR_TYPE_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>

#include "proofmass/numeric/samples.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, Samples::kRowMultiple>;
using V = hn::Vec<D>;
constexpr D kD{};
constexpr std::size_t kLanes = std::min<std::size_t>(HWY_LANES(double), Samples::kRowMultiple);

// Keeps a value that is used twice from being loaded twice, as GCC likes to do: loads are as scarce as
// products.
HWY_INLINE V InRegister(V value) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
  asm("" : "+v"(value.raw));
#endif
  return value;
}

// The value, not needed before `first` is known: keeps what is computed from it from waiting in a register.
HWY_INLINE V After([[maybe_unused]] V first, V value) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
  asm("" : "+v"(value.raw) : "v"(first.raw));
#endif
  return value;
}

// Hides where a pointer comes from, so that what it points to is loaded where it is used, not kept in
// registers that others need and from there on the stack: stores are dearer than loads.
HWY_INLINE const double* Fresh(const double* pointer) {
#if HWY_ARCH_X86
  asm("" : "+r"(pointer));
#endif
  return pointer;
}

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_VECTOR_TYPE_INL
