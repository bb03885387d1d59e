// SPDX-License-Identifier: Apache-2.0
// Fields in forms that the fast reader leaves alone: decimal commas, units in cells, marks of meters, times.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "proofmass/record/csv/number.hpp"

namespace proofmass {

struct LenientNumber {
  double value = 0.0;
  int decimals =
      0;  // digits after the point of the number as written out without its exponent; may be negative
  NumberFault fault = NumberFault::none;
  bool overload =
      false;  // "OVLD", or |value| of 9.9e37 and more: a meter's mark for a value beyond its range
  bool converted = false;  // had characters that look like ASCII ones, or an exponent of Fortran (1.5D+00)
  std::string unit{};      // after the number
};

// Values at which meters set their mark for overload (SCPI: 9.9E+37).
inline constexpr double kOverload = 9.9e37;

// Reads a trimmed field without quotes as a number, with a decimal comma or a decimal point.
[[nodiscard]] LenientNumber read_lenient(std::string_view field, bool decimal_comma);

// Whether the field is a number with a decimal point or comma, or a meter's mark for overload.
[[nodiscard]] bool looks_like_number(std::string_view field);

// Errors that spreadsheets write in place of a value: "#N/A", "#DIV/0!", ….
[[nodiscard]] bool is_spreadsheet_error(std::string_view field) noexcept;

// A point in time.
struct TimePoint {
  double seconds = 0.0;  // since midnight for a clock time, otherwise since 1970-01-01
  bool clock = false;    // a time of day alone
};

// "12:00:01.037", "2025-03-04T08:00:00Z", "2025-03-04 08:00:00,5", "2025/03/04 08:00", "04.03.2025 08:00:00".
[[nodiscard]] std::optional<TimePoint> read_time(std::string_view field);

}  // namespace proofmass
