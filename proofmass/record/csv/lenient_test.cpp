// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/lenient.hpp"

#include <gtest/gtest.h>

#include <string>

namespace proofmass {
namespace {

void expect_number(std::string_view field, double value, int decimals, bool comma = false) {
  const LenientNumber number = read_lenient(field, comma);
  EXPECT_EQ(number.fault, NumberFault::none) << field;
  EXPECT_EQ(number.value, value) << field;
  EXPECT_EQ(number.decimals, decimals) << field;
  EXPECT_FALSE(number.overload) << field;
}

TEST(LenientNumber, ReadsTheFormsOfBenches) {
  expect_number("-2.50", -2.5, 2);
  expect_number("+3", 3.0, 0);
  expect_number("-2,935255", -2.935255, 6, true);
  expect_number("-2.93525500D+00", -2.935255, 8);
  expect_number("4.5d-02", 0.045, 3);
  expect_number("1.25e+3", 1250.0, -1);
  expect_number("\u22122.5", -2.5, 1);                 // minus sign
  expect_number("\uFF0D\uFF12\uFF0E\uFF15", -2.5, 1);  // full-width
  expect_number("3.5\u00A0", 3.5, 1);
  expect_number("=\"2.5\"", 2.5, 1);  // of a spreadsheet
}

TEST(LenientNumber, SaysWhatItConverted) {
  EXPECT_FALSE(read_lenient("2.5", false).converted);
  EXPECT_TRUE(read_lenient("\u22122.5", false).converted);
  EXPECT_TRUE(read_lenient("2.5D0", false).converted);
}

TEST(LenientNumber, TakesAUnitAfterTheNumber) {
  const LenientNumber number = read_lenient("-3.6545 mV", false);
  EXPECT_EQ(number.value, -3.6545);
  EXPECT_EQ(number.unit, "mV");
  EXPECT_EQ(read_lenient("2.5V", false).unit, "V");
  EXPECT_EQ(read_lenient("2.5 parsec", false).fault, NumberFault::not_a_number);
}

TEST(LenientNumber, KnowsMarksOfOverload) {
  for (const char* const field : {"OVLD", "Overload", "+OL", "-O.L.", "9.9E37", "-9.90000000E+37", "1e38"}) {
    EXPECT_TRUE(read_lenient(field, false).overload) << field;
  }
  for (const char* const field : {"9.8e37", "LO", "over 9", ""})
    EXPECT_FALSE(read_lenient(field, false).overload);
}

TEST(LenientNumber, RefusesWhatIsNoNumber) {
  for (const char* const field : {"", "abc", "1,5", "--1", "1.2.3", "0x10", "+-1", "1D", "D5", "#N/A"}) {
    EXPECT_NE(read_lenient(field, false).fault, NumberFault::none) << field;
  }
  for (const char* const field : {"1.5", "1,5,0", "1.234,5"}) {
    EXPECT_NE(read_lenient(field, true).fault, NumberFault::none) << field;
  }
  EXPECT_EQ(read_lenient("nan", false).fault, NumberFault::not_finite);
  EXPECT_EQ(read_lenient("1e999", false).fault, NumberFault::out_of_range);
}

TEST(TimePoint, ReadsClocksAndDates) {
  EXPECT_EQ(read_time("12:00:01.5")->seconds, 43'201.5);
  EXPECT_TRUE(read_time("8:30")->clock);
  const double eight = 1'741'075'200.0;  // 2025-03-04T08:00:00Z
  for (const char* const text :
       {"2025-03-04T08:00:00Z", "2025-03-04 08:00:00", "2025/03/04 08:00", "04.03.2025 08:00:00",
        "2025-03-04T16:00:00+08:00", "2025-03-04T02:30:00-0530"}) {
    const auto time = read_time(text);
    ASSERT_TRUE(time) << text;
    EXPECT_EQ(time->seconds, eight) << text;
    EXPECT_FALSE(time->clock);
  }
  for (const char* const text :
       {"", "12", "12:5", "25:00:00", "2025-13-01", "03/04/2025 08:00", "12:00:00x"}) {
    EXPECT_FALSE(read_time(text)) << text;
  }
}

}  // namespace
}  // namespace proofmass
