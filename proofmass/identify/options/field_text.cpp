// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/options/field_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <type_traits>
#include <utility>

namespace proofmass {
namespace {

// Like std::from_chars, and the text must be a number to its end.
template <typename Number>
bool parse(std::string_view text, Number& number) {
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  return status == std::errc{} && end == text.data() + text.size();
}

template <typename Number>
Message described(const Range<Number>& range) {
  const bool bounded = std::is_integral_v<Number> || range.high < std::numeric_limits<Number>::max();
  Message low = range.above_low ? message("more than {}", range.low) : message("at least {}", range.low);
  if (!bounded) return low;
  if (range.below_high) return message("{} and less than {}", low, range.high);
  if (range.above_low) return message("{} and at most {}", low, range.high);
  return message("from {} to {}", range.low, range.high);
}

template <typename Number>
Number read(std::string_view name, std::string_view text, const Range<Number>& range,
            std::string_view or_word) {
  Number number{};
  if (!parse(text, number) || !range.holds(number)) throw outside_range(name, text, range, or_word);
  return number;
}

template <typename Number>
Message number_in(const Range<Number>& range) {
  const Message description = described(range);
  const bool of = description.english().starts_with("at least");
  if constexpr (std::is_integral_v<Number>) {
    return of ? message("a whole number of {}", description) : message("a whole number {}", description);
  } else {
    return of ? message("a number of {}", description) : message("a number {}", description);
  }
}

Error misplaced(std::string_view name, std::string_view text, const Message& expected) {
  return usage_error(message("{}: {}", name, message("found '{}', expected {}", excerpt(text), expected)));
}

template <typename Number>
Error outside(std::string_view name, std::string_view text, const Range<Number>& range,
              std::string_view or_word) {
  const Message number = number_in(range);
  return misplaced(name, text, or_word.empty() ? number : message("{}, or {}", number, or_word));
}

}  // namespace

std::string number_as_text(double value, double per_unit) {
  const double written = value * per_unit;
  if (per_unit == 1.0 || !std::isfinite(written)) return fmt::format("{}", written);
  std::string shortest;
  for (const double number :
       {written, std::nextafter(written, 0.0), std::nextafter(written, 2.0 * written)}) {
    std::string text = fmt::format("{}", number);
    if (number / per_unit == value && (shortest.empty() || text.size() < shortest.size()))
      shortest = std::move(text);
  }
  return shortest.empty() ? fmt::format("{}", written) : shortest;
}

std::string help_text(std::string_view help, std::span<const double> figures) {
  constexpr std::string_view kPlace = "{}";
  std::string text(help);
  std::size_t from = 0;
  for (const double figure : figures) {
    const std::size_t at = text.find(kPlace, from);
    if (at == std::string::npos) break;
    const std::string number = number_as_text(figure);
    text.replace(at, kPlace.size(), number);
    from = at + number.size();
  }
  return text;
}

double read_number(std::string_view name, std::string_view text, const Range<double>& range,
                   std::string_view or_word) {
  return read(name, text, range, or_word);
}

std::size_t read_number(std::string_view name, std::string_view text, const Range<std::size_t>& range,
                        std::string_view or_word) {
  return read(name, text, range, or_word);
}

Error outside_range(std::string_view name, std::string_view text, const Range<double>& range,
                    std::string_view or_word) {
  return outside(name, text, range, or_word);
}

Error outside_range(std::string_view name, std::string_view text, const Range<std::size_t>& range,
                    std::string_view or_word) {
  return outside(name, text, range, or_word);
}

Error not_one_of(std::string_view name, std::string_view text, std::string_view words) {
  return misplaced(name, text, message("one of {}", words));
}

std::string range_text(const Range<double>& range) { return described(range).english(); }
std::string range_text(const Range<std::size_t>& range) { return described(range).english(); }

}  // namespace proofmass
