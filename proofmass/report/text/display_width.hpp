// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace proofmass {

// The first character of UTF-8 text: its bytes, and the columns that it takes where all letters are alike.
struct DisplayedCharacter {
  std::string_view bytes;
  std::size_t width = 1;  // two: Chinese and full-width ones; none: marks on the character before
};
// The text must not be empty. A byte that is no UTF-8 is a character of its own.
[[nodiscard]] DisplayedCharacter first_character(std::string_view text) noexcept;

// Columns of the whole text.
[[nodiscard]] std::size_t display_width(std::string_view text) noexcept;

}  // namespace proofmass
