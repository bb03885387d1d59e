// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/error.hpp"

#include <gtest/gtest.h>

#include <string>

#include "proofmass/core/utf8.hpp"

namespace proofmass {
namespace {

TEST(BadData, NamesPlaceFoundAndExpected) {
  const Error error = bad_data({.file = "run.csv", .row = 7, .column = "Ai"}, "abc", "a number");
  EXPECT_STREQ(error.what(), "run.csv:7: column 'Ai': found 'abc', expected a number");
  EXPECT_EQ(error.kind(), ErrorKind::bad_data);
}

TEST(BadData, LeavesOutWhatIsUnknown) {
  EXPECT_STREQ(bad_data({.file = "run.csv", .row = 0, .column = ""}, "", "data").what(),
               "run.csv: expected data");
  EXPECT_STREQ(bad_data({.file = "f", .row = 2, .column = ""}, "x", "y").what(),
               "f:2: found 'x', expected y");
}

TEST(BadData, ShortensAndEscapesWhatWasFound) {
  const std::string message =
      bad_data({.file = "f", .row = 1, .column = ""}, std::string(100, 'x'), "less").what();
  EXPECT_EQ(message, "f:1: found '" + std::string(60, 'x') + "...', expected less");
  using namespace std::string_literals;
  EXPECT_STREQ(bad_data({.file = "f", .row = 1, .column = ""}, "\0\x1b\xff µ"s, "text").what(),
               "f:1: found '\\x00\\x1b\\xff µ', expected text");
}

TEST(ExitCode, IsThatOfTheContract) {
  EXPECT_EQ(exit_code(ErrorKind::internal), 1);
  EXPECT_EQ(exit_code(usage_error("").kind()), 2);
  EXPECT_EQ(exit_code(ErrorKind::bad_data), 3);
  EXPECT_EQ(exit_code(refusal("").kind()), 4);
  EXPECT_EQ(exit_code(ErrorKind::interrupted), 130);
}

TEST(Utf8, AcceptsSequencesAndNothingElse) {
  EXPECT_TRUE(is_utf8("g µg ° 加速度 \U0001F600"));
  for (const char* bad : {"\x80", "\xC0\xAF", "\xC3", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80",
                          "\xF5\x80\x80\x80", "\xE2\x28\xA1"}) {
    EXPECT_FALSE(is_utf8(bad));
  }
  EXPECT_EQ(utf8_length("加"), 3U);
  EXPECT_EQ(utf8_length(""), 0U);
}

}  // namespace
}  // namespace proofmass
