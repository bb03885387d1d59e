// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/display_width.hpp"

#include <gtest/gtest.h>

namespace proofmass {
namespace {

TEST(DisplayWidth, CountsChineseAndFullWidthCharactersAsTwo) {
  EXPECT_EQ(display_width(""), 0U);
  EXPECT_EQ(display_width("abc"), 3U);
  EXPECT_EQ(display_width("13.0 ± 0.2 µg/g²"), 16U);
  EXPECT_EQ(display_width("零偏"), 4U);
  EXPECT_EQ(display_width("标度因数 Ki：1，（K0）。"), 24U);
  EXPECT_EQ(display_width("Ａ１"), 4U);
  EXPECT_EQ(display_width("日本カナ한글"), 12U);
  EXPECT_EQ(display_width("𠀀"), 2U);
  EXPECT_EQ(display_width("1、2……"), 6U);
  EXPECT_EQ(display_width("e\u0301"), 1U);
  EXPECT_EQ(display_width("ｱ"), 1U);  // half-width
}

TEST(DisplayWidth, CountsABrokenByteAsOne) {
  EXPECT_EQ(display_width("\xE9x"), 2U);
  EXPECT_EQ(first_character("\xE9x").bytes, "\xE9");
  EXPECT_EQ(first_character("零x").bytes, "零");
  EXPECT_EQ(first_character("零x").width, 2U);
}

}  // namespace
}  // namespace proofmass
