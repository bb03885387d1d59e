// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/utf8.hpp"

namespace proofmass {
namespace {

struct Lead {
  std::size_t length = 0;
  unsigned second_low = 0x80;   // bounds of the second byte, which exclude
  unsigned second_high = 0xBF;  // overlong forms, surrogates and too large values
};

Lead lead(unsigned byte) noexcept {
  if (byte < 0x80) return {.length = 1};
  if (byte >= 0xC2 && byte <= 0xDF) return {.length = 2};
  if (byte == 0xE0) return {.length = 3, .second_low = 0xA0};
  if (byte == 0xED) return {.length = 3, .second_high = 0x9F};
  if (byte >= 0xE1 && byte <= 0xEF) return {.length = 3};
  if (byte == 0xF0) return {.length = 4, .second_low = 0x90};
  if (byte == 0xF4) return {.length = 4, .second_high = 0x8F};
  if (byte >= 0xF1 && byte <= 0xF3) return {.length = 4};
  return {};
}

}  // namespace

std::size_t utf8_length(std::string_view text) noexcept {
  const auto byte = [text](std::size_t k) { return unsigned{static_cast<unsigned char>(text[k])}; };
  if (text.empty()) return 0;
  const Lead first = lead(byte(0));
  if (first.length > text.size()) return 0;
  if (first.length > 1 && (byte(1) < first.second_low || byte(1) > first.second_high)) return 0;
  for (std::size_t k = 2; k < first.length; ++k) {
    if (byte(k) < 0x80 || byte(k) > 0xBF) return 0;
  }
  return first.length;
}

bool is_utf8(std::string_view text) noexcept {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace proofmass
