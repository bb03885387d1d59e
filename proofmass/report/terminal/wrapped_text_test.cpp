// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/wrapped_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>
#include <string>
#include <vector>

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
