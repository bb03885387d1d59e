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

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Length of the "e-06" that begins there, behind a digit, a point or a bracket and before no letter; 0 for
// none.
std::size_t exponent_at(std::string_view text, std::size_t k) {
  if (text[k] != 'e' || k == 0) return 0;
  const char before = text[k - 1];
  if (!is_digit(before) && before != '.' && before != ')' && before != ']') return 0;
  std::size_t end = k + 1;
  if (end < text.size() && (text[end] == '-' || text[end] == '+')) ++end;
  const std::size_t digits = end;
  while (end < text.size() && is_digit(text[end])) ++end;
  return end > digits ? end - k : 0;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Before a number, or between two with spaces; a hyphen between words, or within 3-7-1, is none.
bool is_minus(std::string_view text, std::size_t k) {
  if (text[k] != '-' || k + 1 == text.size()) return false;
  const bool spaced = text[k + 1] == ' ';
  const std::size_t next = k + (spaced ? 2 : 1);
  if (next >= text.size() || (!is_digit(text[next]) && text[next] != '.')) return false;
  if (k == 0) return !spaced;
  const char before = text[k - 1];
  if (spaced) return before == ' ' && k > 1 && is_digit(text[k - 2]);
  return !is_digit(before) && !is_letter(before);
}

}  // namespace

std::string power_of_ten(int exponent) { return "10" + raised(exponent); }

std::string typeset(std::string_view text) {
  std::string out;
  for (std::size_t k = 0; k < text.size();) {
    const std::size_t exponent = exponent_at(text, k);
    if (exponent > 0) {
      const std::size_t start = text[k + 1] == '+' ? k + 2 : k + 1;
      int power = 0;
      std::from_chars(text.data() + start, text.data() + k + exponent, power);
      out += " × " + power_of_ten(power);
      k += exponent;
    } else {
      out += is_minus(text, k) ? "−" : std::string(1, text[k]);
      ++k;
    }
  }
  return out;
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

std::string squared_unit(std::string_view unit) {
  const std::string printed = typeset_unit(unit);
  const bool plain = unit.find_first_of("/ ^") == std::string_view::npos;
  return plain ? printed + "²" : "(" + printed + ")²";
}

}  // namespace proofmass
