// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace proofmass {

// Number of bytes of the UTF-8 sequence at the beginning of `text`: 1 to 4, or 0 when the text is empty or
// the bytes are not a sequence (Unicode 15, Table 3-7, which excludes overlong forms, surrogates and values
// above U+10FFFF).
[[nodiscard]] std::size_t utf8_length(std::string_view text) noexcept;

[[nodiscard]] bool is_utf8(std::string_view text) noexcept;

}  // namespace proofmass
