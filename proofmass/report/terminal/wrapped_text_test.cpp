// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/wrapped_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "proofmass/report/text/display_width.hpp"

namespace proofmass {
namespace {

using Lines = std::vector<std::string>;

TEST(WrappedText, BreaksAtBlanks) {
  EXPECT_EQ(wrapped_lines("one two three", 8), (Lines{"one two", "three"}));
  EXPECT_EQ(wrapped_lines("one two three", 8, 2), (Lines{"one two", "  three"}));
  EXPECT_EQ(wrapped_lines("  one two three", 9, 4), (Lines{"  one two", "    three"}));
  EXPECT_EQ(wrapped_lines("one incomprehensibilities", 8), (Lines{"one", "incomprehensibilities"}));
  EXPECT_EQ(wrapped_lines("one two three", 0), (Lines{"one two three"}));
  EXPECT_EQ(wrapped_lines("", 8), (Lines{""}));
  EXPECT_EQ(wrapped_lines("± µ ² ³", 7), (Lines{"± µ ² ³"}));
}

TEST(WrappedText, BreaksChineseBetweenCharacters) {
  EXPECT_EQ(wrapped_lines("残差标准差", 6), (Lines{"残差标", "准差"}));
  EXPECT_EQ(wrapped_lines("残差标准差", 7, 2), (Lines{"残差标", "  准差"}));
  EXPECT_EQ(wrapped_lines("残差 0.25 mg", 8), (Lines{"残差", "0.25 mg"}));
  EXPECT_EQ(wrapped_lines("系数K0与Kii", 6), (Lines{"系数K0", "与Kii"}));
}

TEST(WrappedText, KeepsClosingPunctuationWithWhatItClosesAndOpeningWithWhatItOpens) {
  EXPECT_EQ(wrapped_lines("残差标，准差", 6), (Lines{"残差", "标，准", "差"}));
  EXPECT_EQ(wrapped_lines("零偏（K0）小。", 8), (Lines{"零偏", "（K0）", "小。"}));
  EXPECT_EQ(wrapped_lines("第 4、9……行", 10), (Lines{"第 4、9……", "行"}));
}

RC_GTEST_PROP(WrappedText, KeepsEveryCharacterOfChinese, ()) {
  const std::vector<std::string> kinds{"零", "偏", "，", "（", "）", "。", " ", "K", "0", "µ"};
  const auto picked = *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, 10));
  std::string text = "标";
  std::string solid = text;
  for (const std::size_t k : picked) {
    text += kinds[k];
    if (kinds[k] != " ") solid += kinds[k];
  }
  std::string joined;
  for (const std::string& line : wrapped_lines(text, 30, 2)) {
    for (const char* const closing : {"，", "。", "）"}) {
      // Unless a blank stood there.
      RC_ASSERT(!line.starts_with(std::string("  ") + closing) ||
                text.find(std::string(" ") + closing) != std::string::npos);
    }
    for (const char c : line) {
      if (c != ' ') joined += c;
    }
  }
  RC_ASSERT(joined == solid);
}

RC_GTEST_PROP(WrappedText, KeepsTheWordsAndTheWidth, ()) {
  const auto lengths = *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 12));
  const auto width = *rc::gen::inRange<std::size_t>(15, 40);
  std::string text;
  for (const std::size_t length : lengths) text += (text.empty() ? "" : " ") + std::string(length, 'x');
  std::string joined;
  for (const std::string& line : wrapped_lines(text, width, 2)) {
    RC_ASSERT(display_width(line) <= width);
    std::istringstream words(line);
    for (std::string word; words >> word;) joined += (joined.empty() ? "" : " ") + word;
  }
  RC_ASSERT(joined == text);
}

}  // namespace
}  // namespace proofmass
