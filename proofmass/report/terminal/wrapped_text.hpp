// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace proofmass {

// Lines of at most `width` columns, broken at blanks and beside Chinese characters, but not before
// punctuation that closes nor after punctuation that opens; a word that is longer has a line of its own.
// Lines after the first begin with `indent` blanks. A width of 0 breaks nothing.
[[nodiscard]] std::vector<std::string> wrapped_lines(std::string_view text, std::size_t width,
                                                     std::size_t indent = 0);

}  // namespace proofmass
