// SPDX-License-Identifier: Apache-2.0
// Fields of one line of a CSV file (RFC 4180, but a quoted field ends on its line).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace proofmass {

// Comma, semicolon or tab: the one that a header line holds most of outside quotes; comma when it holds none.
[[nodiscard]] char detect_separator(std::string_view header) noexcept;

// A tab is a blank unless it separates.
[[nodiscard]] constexpr bool is_blank(char c, char separator) noexcept {
  return c == ' ' || (c == '\t' && separator != '\t');
}
[[nodiscard]] std::string_view trim(std::string_view text, char separator) noexcept;

// The separator that ends the field beginning at `first`, or `last`.
[[nodiscard]] const char* field_end(const char* first, const char* last, char separator) noexcept;

// The fields of a line as written, without surrounding blanks.
[[nodiscard]] std::vector<std::string_view> split_fields(std::string_view line, char separator);

// The text of a trimmed field: quotes removed, "" inside them made one. Nothing when quotes do not match.
[[nodiscard]] std::optional<std::string> unquoted(std::string_view field);

// Lines that carry no data: blank, or a comment.
[[nodiscard]] bool is_skipped(std::string_view line) noexcept;

}  // namespace proofmass
