// SPDX-License-Identifier: Apache-2.0
// Fields of one line of a CSV file (RFC 4180, except that a quoted field must end on its line).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace proofmass {

// The most frequent of comma, semicolon and tab in a header line, outside quotes and brackets; a blank when
// there is none of them, but blanks between words; else comma.
[[nodiscard]] char detect_separator(std::string_view header) noexcept;

// A tab counts as a blank unless it is the separator.
[[nodiscard]] constexpr bool is_blank(char c, char separator) noexcept {
  return c == ' ' || (c == '\t' && separator != '\t');
}
[[nodiscard]] std::string_view trim(std::string_view text, char separator) noexcept;

// The separator that ends the field which begins at `first`, or `last`.
[[nodiscard]] const char* field_end(const char* first, const char* last, char separator) noexcept;

// The fields of a line as written, without surrounding blanks.
[[nodiscard]] std::vector<std::string_view> split_fields(std::string_view line, char separator);

// The text of a trimmed field: quotes removed, "" inside them replaced by ". Empty when quotes do not match.
[[nodiscard]] std::optional<std::string> unquoted(std::string_view field);

// Characters that look like ASCII ones as those: full-width letters, digits and punctuation, minus and dash
// as '-', blanks of any width as ' '.
[[nodiscard]] std::string plain_characters(std::string_view text);

}  // namespace proofmass
