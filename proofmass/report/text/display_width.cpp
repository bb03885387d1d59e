// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/display_width.hpp"

#include <algorithm>
#include <array>

#include "proofmass/core/utf8.hpp"

namespace proofmass {
namespace {

struct CodePoints {
  char32_t first, last;
};

// Wide and full-width ones (Unicode 15, East Asian Width W and F, in blocks).
constexpr std::array kWide{
    CodePoints{0x1100, 0x115F},   CodePoints{0x2E80, 0x303E},   CodePoints{0x3041, 0x4DBF},
    CodePoints{0x4E00, 0xA4CF},   CodePoints{0xA960, 0xA97F},   CodePoints{0xAC00, 0xD7A3},
    CodePoints{0xF900, 0xFAFF},   CodePoints{0xFE10, 0xFE19},   CodePoints{0xFE30, 0xFE6F},
    CodePoints{0xFF01, 0xFF60},   CodePoints{0xFFE0, 0xFFE6},   CodePoints{0x1F300, 0x1F64F},
    CodePoints{0x1F900, 0x1F9FF}, CodePoints{0x20000, 0x3FFFD},
};

// Marks over or under the character before, and characters that select its form.
constexpr std::array kWithoutWidth{
    CodePoints{0x0300, 0x036F}, CodePoints{0x200B, 0x200F}, CodePoints{0x20D0, 0x20FF},
    CodePoints{0xFE00, 0xFE0F}, CodePoints{0xFEFF, 0xFEFF},
};

bool within(char32_t point, const auto& ranges) noexcept {
  return std::any_of(ranges.begin(), ranges.end(), [point](const CodePoints& range) {
    return range.first <= point && point <= range.last;
  });
}

// The code point of one whole sequence.
char32_t code_point(std::string_view bytes) noexcept {
  constexpr std::array kLeadingBits{0x7FU, 0x1FU, 0x0FU, 0x07U};
  char32_t point = static_cast<unsigned char>(bytes.front()) & kLeadingBits[bytes.size() - 1];
  for (const char byte : bytes.substr(1)) point = (point << 6U) | (static_cast<unsigned char>(byte) & 0x3FU);
  return point;
}

}  // namespace

DisplayedCharacter first_character(std::string_view text) noexcept {
  const std::size_t length = utf8_length(text);
  if (length == 0) return {.bytes = text.substr(0, 1)};
  const std::string_view bytes = text.substr(0, length);
  const char32_t point = code_point(bytes);
  if (within(point, kWithoutWidth)) return {.bytes = bytes, .width = 0};
  return {.bytes = bytes, .width = within(point, kWide) ? 2U : 1U};
}

std::size_t display_width(std::string_view text) noexcept {
  std::size_t width = 0;
  while (!text.empty()) {
    const DisplayedCharacter character = first_character(text);
    width += character.width;
    text.remove_prefix(character.bytes.size());
  }
  return width;
}

}  // namespace proofmass
