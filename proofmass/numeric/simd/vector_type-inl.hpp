// SPDX-License-Identifier: Apache-2.0
// The vector type of the kernels over samples, for every instruction set. The file is included through
// foreach_target, so it has no ordinary include guard.
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

// Prevents GCC from loading a value twice that is used twice: loads are as limited as products.
HWY_INLINE V InRegister(V value) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
  asm("" : "+v"(value.raw));
#endif
  return value;
}

// Makes the value depend on `first`, so that results computed from it do not occupy a register too early.
HWY_INLINE V After([[maybe_unused]] V first, V value) {
#if HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128
  asm("" : "+v"(value.raw) : "v"(first.raw));
#endif
  return value;
}

// Hides the origin of a pointer from the compiler, so that values are loaded where they are used. Otherwise
// they would stay in registers that others need, and be spilled to the stack: stores are more expensive than
// loads.
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
