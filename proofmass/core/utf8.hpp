// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace proofmass {

// Bytes of the UTF-8 sequence that `text` begins with: 1 to 4; 0 when it is empty or begins with none
// (Unicode 15, Table 3-7: overlong forms, surrogates and values above U+10FFFF are not sequences).
[[nodiscard]] std::size_t utf8_length(std::string_view text) noexcept;

[[nodiscard]] bool is_utf8(std::string_view text) noexcept;

}  // namespace proofmass
