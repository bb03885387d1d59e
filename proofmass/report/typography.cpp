// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/typography.hpp"

#include <array>
#include <charconv>

namespace proofmass {
namespace {

constexpr std::array<std::string_view, 10> kRaised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

std::string raised(int number) {
  std::string text = number < 0 ? "⁻" : "";
  for (const char digit : std::to_string(number < 0 ? -number : number))
    text += kRaised.at(static_cast<std::size_t>(digit - '0'));
  return text;
}

std::string with_minus(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '-') {
      out += "−";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

std::string power_of_ten(int exponent) { return "10" + raised(exponent); }

std::string typeset(std::string_view number) {
  const std::size_t e = number.find('e');
  if (e == std::string_view::npos || e + 1 == number.size() || e == 0) return with_minus(number);
  const std::size_t start = number[e + 1] == '+' ? e + 2 : e + 1;
  int exponent = 0;
  const char* const end = number.data() + number.size();
  const auto parsed = std::from_chars(number.data() + start, end, exponent);
  if (parsed.ec != std::errc() || parsed.ptr != end) return with_minus(number);
  return with_minus(number.substr(0, e)) + " × " + power_of_ten(exponent);
}

std::string typeset_unit(std::string_view unit) {
  std::string out;
  for (std::size_t k = 0; k < unit.size(); ++k) {
    if (unit[k] == '^' && k + 1 < unit.size() && unit[k + 1] >= '0' && unit[k + 1] <= '9') {
      out += kRaised.at(static_cast<std::size_t>(unit[++k] - '0'));
    } else {
      out += unit[k];
    }
  }
  const bool micro = out.size() > 1 && out[0] == 'u' && (out[1] == 'g' || out[1] == 'V' || out[1] == 'A');
  return micro ? "µ" + out.substr(1) : out;
}

std::size_t text_columns(std::string_view utf8) {
  constexpr unsigned char kChineseFrom = 0xE3, kContinuation = 0x80, kMask = 0xC0;
  std::size_t columns = 0;
  for (const char c : utf8) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & kMask) == kContinuation) continue;
    columns += byte >= kChineseFrom ? 2 : 1;
  }
  return columns;
}

}  // namespace proofmass
