// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/simd/double_double.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

constexpr double kUnit = 0x1p-106;

DoubleDouble random_value(RandomStream& random) {
  const double high = std::ldexp(random.normal(), static_cast<int>(random.uniform(-40.0, 40.0)));
  return fast_exact_sum(high, high * 0x1p-53 * random.uniform(-0.9, 0.9));
}

double relative_error(const DoubleDouble& found, const DoubleDouble& expected) {
  const DoubleDouble error = found - expected;
  return std::abs(error.value() / expected.value());
}

TEST(DoubleDouble, HoldsWhatDoublesCannot) {
  const DoubleDouble sum = DoubleDouble(1.0) + DoubleDouble(0x1p-80);
  EXPECT_EQ(sum.high, 1.0);
  EXPECT_EQ(sum.low, 0x1p-80);
  // 1/3 = 0.0101…b: the low part is a third of the high part's last place.
  const DoubleDouble third = DoubleDouble(1.0) / DoubleDouble(3.0);
  EXPECT_EQ(third.high, 1.0 / 3.0);
  EXPECT_EQ(third.low, 0x1p-54 / 3.0);
  // (2^52 + 1)² = 2^104 + 2^53 + 1.
  const DoubleDouble square = exact_product(0x1p52 + 1.0, 0x1p52 + 1.0);
  EXPECT_EQ(square.high, 0x1p104 + 0x1p53);
  EXPECT_EQ(square.low, 1.0);
  EXPECT_EQ(sqrt(DoubleDouble(0.0)).value(), 0.0);
}

RC_GTEST_PROP(DoubleDouble, InverseOperationsUndoEachOther, (std::uint64_t seed)) {
  RandomStream random(seed);
  const DoubleDouble a = random_value(random);
  const DoubleDouble b = random_value(random);
  RC_ASSERT(relative_error(a * b / b, a) < 20.0 * kUnit);
  RC_ASSERT(relative_error(sqrt(a * a), a.high < 0.0 ? -a : a) < 20.0 * kUnit);
  const double larger = std::max(std::abs(a.value()), std::abs(b.value()));
  RC_ASSERT(std::abs((a + b - b - a).value()) <= 10.0 * kUnit * larger);
}

RC_GTEST_PROP(DoubleDouble, ProductsDistributeOverSums, (std::uint64_t seed)) {
  RandomStream random(seed);
  const DoubleDouble a = random_value(random);
  const DoubleDouble b = random_value(random);
  const DoubleDouble c = random_value(random);
  const double size = std::abs(a.value()) * (std::abs(b.value()) + std::abs(c.value()));
  RC_ASSERT(std::abs((a * (b + c) - (a * b + a * c)).value()) <= 40.0 * kUnit * size);
}

}  // namespace
}  // namespace proofmass
