// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "proofmass/record/csv/decimal.hpp"

namespace proofmass {
namespace {

bool looks_like_decimal_comma(std::string_view field) {
  if (std::count(field.begin(), field.end(), ',') != 1) return false;
  std::string with_point(field);
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  return number_fault(with_point) == NumberFault::none;
}

// Of a number in the form that from_chars reads.
int decimals_of(std::string_view number) noexcept {
  const auto exponent_at = std::min(number.find_first_of("eE"), number.size());
  const auto point = number.find('.');
  int decimals = point < exponent_at ? static_cast<int>(exponent_at - point) - 1 : 0;
  if (exponent_at == number.size()) return decimals;
  const char* first = number.data() + exponent_at + 1;
  const char* const last = number.data() + number.size();
  if (first != last && *first == '+') ++first;
  int exponent = 0;
  (void)std::from_chars(first, last, exponent);
  return decimals - exponent;
}

}  // namespace

ScannedNumber scan_number(const char* first, const char* last) noexcept {
  if (const Decimal plain = scan_decimal(first, last); plain.end != nullptr) {
    return {.value = plain.value, .end = plain.end, .fault = NumberFault::none, .decimals = plain.decimals};
  }
  ScannedNumber number;
  if (first != last && *first == '+') {
    ++first;
    if (first != last && *first == '-')
      return {.value = 0.0, .end = first, .fault = NumberFault::not_a_number, .decimals = 0};
  }
  const auto [end, status] = std::from_chars(first, last, number.value);
  number.end = end;
  number.decimals = decimals_of({first, static_cast<std::size_t>(end - first)});
  if (status == std::errc::result_out_of_range) {
    number.fault = NumberFault::out_of_range;
  } else if (status != std::errc()) {
    number.fault = NumberFault::not_a_number;
  } else if (!std::isfinite(number.value)) {
    number.fault = NumberFault::not_finite;
  }
  return number;
}

NumberFault number_fault(std::string_view field) noexcept {
  const char* const last = field.data() + field.size();
  const ScannedNumber number = scan_number(field.data(), last);
  return number.end == last ? number.fault : NumberFault::not_a_number;
}

Message expected_number(std::string_view field, NumberFault fault) {
  if (field.empty()) return message("a number, not an empty field");
  if (fault == NumberFault::not_finite) return message("a finite number");
  if (fault == NumberFault::out_of_range) return message("a number within the range of double precision");
  if (looks_like_decimal_comma(field)) return message("a number with a decimal point, not a decimal comma");
  return message("a number");
}

}  // namespace proofmass
