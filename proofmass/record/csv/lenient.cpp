// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/lenient.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cmath>

#include "proofmass/core/units.hpp"
#include "proofmass/record/csv/fields.hpp"

namespace proofmass {
namespace {

bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

std::string upper_letters(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0)
      letters += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return letters;
}

bool is_overload_word(std::string_view field) {
  constexpr std::array<std::string_view, 10> words{"OVLD",  "OVERLOAD",  "OVERLD", "OL",       "OVR",
                                                   "OVRNG", "OVERRANGE", "OVER",   "OVERFLOW", "OVF"};
  if (field.empty() || std::any_of(field.begin(), field.end(), is_digit)) return false;
  return std::find(words.begin(), words.end(), upper_letters(field)) != words.end();
}

// "1.5D+00" as "1.5E+00": between a digit or point and a digit or sign.
bool use_plain_exponent(std::string& text) {
  for (std::size_t k = 1; k + 1 < text.size(); ++k) {
    if (text[k] != 'D' && text[k] != 'd') continue;
    const bool before = is_digit(text[k - 1]) || text[k - 1] == '.';
    const bool after = is_digit(text[k + 1]) || text[k + 1] == '+' || text[k + 1] == '-';
    if (!before || !after) return false;
    text[k] = 'E';
    return true;
  }
  return false;
}

// False when the text cannot be a number with a decimal comma.
bool use_decimal_point(std::string& text) {
  if (text.find('.') != std::string::npos || std::count(text.begin(), text.end(), ',') > 1) return false;
  std::replace(text.begin(), text.end(), ',', '.');
  return true;
}

// Takes a whole number of a least and a greatest number of digits from the front of the text.
bool take_digits(std::string_view& text, std::size_t least, std::size_t most, int& value) noexcept {
  std::size_t count = 0;
  value = 0;
  while (count < text.size() && count < most && is_digit(text[count]))
    value = 10 * value + (text[count++] - '0');
  text.remove_prefix(count);
  return count >= least;
}

bool take(std::string_view& text, std::string_view any_of) noexcept {
  if (text.empty() || any_of.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

// Hours and minutes, then perhaps seconds with decimals.
std::optional<double> take_clock(std::string_view& text) noexcept {
  int hours = 0;
  int minutes = 0;
  int seconds = 0;
  if (!take_digits(text, 1, 2, hours) || !take(text, ":") || !take_digits(text, 2, 2, minutes))
    return std::nullopt;
  if (hours > 24 || minutes > 59) return std::nullopt;
  double fraction = 0.0;
  if (take(text, ":")) {
    if (!take_digits(text, 2, 2, seconds) || seconds > 60) return std::nullopt;
    if (take(text, ".,")) {
      double weight = 0.1;
      if (text.empty() || !is_digit(text.front())) return std::nullopt;
      for (; !text.empty() && is_digit(text.front()); text.remove_prefix(1), weight /= 10.0)
        fraction += weight * (text.front() - '0');
    }
  }
  if (hours == 24 && (minutes > 0 || seconds > 0 || fraction > 0.0)) return std::nullopt;
  return 3600.0 * hours + 60.0 * minutes + seconds + fraction;
}

// Seconds to take off for an offset from UTC as "Z", "+08:00", "-0530".
std::optional<double> take_offset(std::string_view& text) noexcept {
  if (text.empty()) return 0.0;
  if (take(text, "Zz")) return 0.0;
  const double sign = text.front() == '-' ? -1.0 : 1.0;
  int hours = 0;
  int minutes = 0;
  if (!take(text, "+-") || !take_digits(text, 2, 2, hours)) return std::nullopt;
  if (take(text, ":") || !text.empty()) {
    if (!take_digits(text, 2, 2, minutes)) return std::nullopt;
  }
  return sign * (3600.0 * hours + 60.0 * minutes);
}

// Days since 1970-01-01.
std::optional<double> take_date(std::string_view& text) noexcept {
  std::string_view rest = text;
  int first = 0;
  int month = 0;
  int last = 0;
  if (!take_digits(rest, 1, 4, first) || rest.empty()) return std::nullopt;
  const char mark = rest.front();
  const std::string_view marks(&mark, 1);
  if (!take(rest, "-/.") || !take_digits(rest, 1, 2, month) || !take(rest, marks) ||
      !take_digits(rest, 1, 4, last))
    return std::nullopt;
  const bool year_first = first > 31;
  if (!year_first && (mark != '.' || last < 1000)) return std::nullopt;  // day or month first is not said
  const std::chrono::year_month_day date{std::chrono::year(year_first ? first : last),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(year_first ? last : first))};
  if (!date.ok()) return std::nullopt;
  text = rest;
  return static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
}

}  // namespace

LenientNumber read_lenient(std::string_view field, bool decimal_comma) {
  LenientNumber number;
  std::string text = plain_characters(field);
  number.converted = text != field;
  text = trim(text, ',');
  if (text.size() > 3 && text.starts_with("=\"") &&
      text.ends_with('"')) {  // how spreadsheets keep text as it is
    text = text.substr(2, text.size() - 3);
    number.converted = true;
  }
  if (is_overload_word(text)) {
    number.overload = true;
    number.fault = NumberFault::not_a_number;
    return number;
  }
  if (decimal_comma && !use_decimal_point(text)) {
    number.fault = NumberFault::not_a_number;
    return number;
  }
  if (use_plain_exponent(text)) number.converted = true;
  const char* const last = text.data() + text.size();
  const ScannedNumber scanned = scan_number(text.data(), last);
  number.value = scanned.value;
  number.fault = scanned.fault;
  if (number.fault != NumberFault::none) {
    if (scanned.end != last) number.fault = NumberFault::not_a_number;
    return number;
  }
  const auto length = static_cast<std::size_t>(scanned.end - text.data());
  number.decimals = scanned.decimals;
  number.overload = std::abs(number.value) >= kOverload;
  const std::string_view rest = trim(std::string_view(text).substr(length), ',');
  if (!rest.empty()) {
    number.unit = rest;
    if (!find_unit(rest)) number.fault = NumberFault::not_a_number;
  }
  return number;
}

bool looks_like_number(std::string_view field) {
  const LenientNumber number = read_lenient(field, false);
  return number.fault == NumberFault::none || number.overload ||
         read_lenient(field, true).fault == NumberFault::none;
}

bool is_spreadsheet_error(std::string_view field) noexcept {
  constexpr std::array<std::string_view, 8> errors{"#N/A",   "#DIV/0!", "#VALUE!", "#REF!",
                                                   "#NAME?", "#NUM!",   "#NULL!",  "#WERT!"};
  return std::find(errors.begin(), errors.end(), field) != errors.end();
}

std::optional<TimePoint> read_time(std::string_view field) {
  const std::string plain = plain_characters(field);
  std::string_view text = trim(plain, ',');
  if (const auto days = take_date(text)) {
    double seconds = 86'400.0 * *days;
    if (text.empty()) return TimePoint{.seconds = seconds, .clock = false};
    if (!take(text, "T ")) return std::nullopt;
    const auto clock = take_clock(text);
    if (!clock) return std::nullopt;
    const auto offset = take_offset(text);
    if (!offset || !text.empty()) return std::nullopt;
    return TimePoint{.seconds = seconds + *clock - *offset, .clock = false};
  }
  const auto clock = take_clock(text);
  if (!clock || !text.empty()) return std::nullopt;
  return TimePoint{.seconds = *clock, .clock = true};
}

}  // namespace proofmass
