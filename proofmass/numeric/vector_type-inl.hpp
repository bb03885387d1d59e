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

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_VECTOR_TYPE_INL
