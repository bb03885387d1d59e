// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace proofmass {

// Columns that UTF-8 text takes on a terminal: its code points, for all that our units need (µ, ², ³, ±) is
// one wide.
[[nodiscard]] std::size_t display_width(std::string_view text) noexcept;

// Lines of at most `width` columns, broken at blanks; a word that is longer has a line of its own. Lines
// after the first begin with `indent` blanks. A width of 0 breaks nothing.
[[nodiscard]] std::vector<std::string> wrapped_lines(std::string_view text, std::size_t width,
                                                     std::size_t indent = 0);

}  // namespace proofmass
