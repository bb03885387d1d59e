// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/number.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "proofmass/record/csv/decimal.hpp"

namespace proofmass {
namespace {

// The result has the same bits as strtod's, and ends at the same character.
void expect_as_strtod(const std::string& text) {
  char* end = nullptr;
  const double expected = std::strtod(text.c_str(), &end);
  const ScannedNumber number = scan_number(text.data(), text.data() + text.size());
  ASSERT_EQ(number.fault, NumberFault::none) << text;
  ASSERT_EQ(std::bit_cast<std::uint64_t>(number.value), std::bit_cast<std::uint64_t>(expected)) << text;
  ASSERT_EQ(number.end - text.data(), end - text.c_str()) << text;
}

std::string any_digits(std::size_t count) {
  return *rc::gen::container<std::string>(count, rc::gen::inRange('0', static_cast<char>('9' + 1)));
}

RC_GTEST_PROP(ScanNumber, ReadsDigitsOfEveryLengthAsStrtod, ()) {
  const auto whole = *rc::gen::inRange<std::size_t>(1, 30);
  const auto sign = *rc::gen::elementOf(std::vector<std::string>{"", "-", "+"});
  const auto tail = *rc::gen::elementOf(std::vector<std::string>{"", ",", " ", "\r", "/", ":", ",12345678"});
  const std::string digits = sign + any_digits(whole);
  expect_as_strtod(digits + tail);
  for (std::size_t decimals = 0; decimals < 32; ++decimals) {
    std::string fraction = ".";
    fraction.append(any_digits(decimals)).append(tail);
    expect_as_strtod(digits + fraction);
    if (decimals > 0) expect_as_strtod(sign + fraction);
  }
}

RC_GTEST_PROP(ScanNumber, ReadsTheShortestFormOfAnyDouble, (std::uint64_t bits)) {
  const auto value = std::bit_cast<double>(bits);
  RC_PRE(std::isfinite(value));
  std::string text(400, '\0');
  for (const auto format : {std::chars_format::fixed, std::chars_format::scientific}) {
    const auto written = std::to_chars(text.data(), text.data() + text.size(), value, format);
    const ScannedNumber number = scan_number(text.data(), written.ptr);
    RC_ASSERT(std::bit_cast<std::uint64_t>(number.value) == bits);
    RC_ASSERT(number.end == written.ptr);
  }
}

// A number midway between two doubles, and its neighbours one unit of the last decimal away.
RC_GTEST_PROP(ScanNumber, RoundsTiesToEven, ()) {
  const auto odd = *rc::gen::inRange<std::int64_t>(std::int64_t{1} << 53, std::int64_t{1} << 54) | 1;
  for (const std::int64_t nearby : {odd - 1, odd, odd + 1}) {
    expect_as_strtod(std::to_string(nearby));
    expect_as_strtod(std::to_string(nearby) + ".0");
  }
  const auto half = std::to_string(odd / 2) + ".5";
  expect_as_strtod(half);
  expect_as_strtod(half + "0000");
  expect_as_strtod(half + "0000000000000001");
}

TEST(ScanNumber, LeavesExponentsAndOtherTextToTheGeneralWay) {
  for (const std::string text :
       {"1e5", "-2.5E-3", "1e", "3.25e+", "12345678e", "0", "-0", "-0.0", "1.", ".5"}) {
    expect_as_strtod(text);
  }
  for (const std::string text : {"", "-", ".", "-.", "+-1", "e5", "x", ",1"}) {
    EXPECT_EQ(scan_number(text.data(), text.data() + text.size()).fault, NumberFault::not_a_number) << text;
  }
  EXPECT_EQ(number_fault("inf"), NumberFault::not_finite);
  EXPECT_EQ(number_fault("1e400"), NumberFault::out_of_range);
}

TEST(ScanDecimal, ReadsWhatRecordsHold) {
  for (const std::string text :
       {"-4.976407076545105", "1234567890123456", "0.1", "7", "-0.00012345678901234567"}) {
    const Decimal number = scan_decimal(text.data(), text.data() + text.size());
    EXPECT_EQ(number.end, text.data() + text.size()) << text;
    EXPECT_EQ(number.value, std::strtod(text.c_str(), nullptr)) << text;
  }
}

}  // namespace
}  // namespace proofmass
