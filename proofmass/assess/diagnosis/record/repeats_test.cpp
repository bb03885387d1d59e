// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/repeats.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

namespace proofmass {
namespace {

using Column = std::vector<double>;

TEST(CountRepeats, CountsRowsThatEqualAnEarlierOne) {
  const Column a{1, 2, 1, 1, 2};
  const Column b{5, 6, 5, 7, 6};
  EXPECT_EQ(count_repeats(5, std::array{&a}), 3U);
  EXPECT_EQ(count_repeats(5, std::array{&a, &b}), 2U);
  EXPECT_EQ(count_repeats(0, std::array{&a}), 0U);
}

TEST(CountRepeats, ZeroEqualsMinusZero) {
  const Column zeros{0.0, -0.0, 5e-324, -5e-324};
  EXPECT_EQ(count_repeats(4, std::array{&zeros}), 1U);
}

TEST(CountRepeats, OneRowMayFillTheRecord) {
  const Column same(100'000, 9.80665);
  EXPECT_EQ(count_repeats(same.size(), std::array{&same}), same.size() - 1);
}

RC_GTEST_PROP(CountRepeats, AgreesWithASet, ()) {
  const auto level = rc::gen::map(rc::gen::inRange(-4, 5), [](int k) { return 0.1 * k; });
  const auto a = *rc::gen::container<Column>(level);
  const auto b = *rc::gen::container<Column>(a.size(), level);
  std::set<std::pair<double, double>> distinct;
  for (std::size_t k = 0; k < a.size(); ++k) distinct.emplace(a[k], b[k]);
  RC_ASSERT(count_repeats(a.size(), std::array{&a, &b}) == a.size() - distinct.size());
}

}  // namespace
}  // namespace proofmass
