// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/fields.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace proofmass {

char detect_separator(std::string_view header) noexcept {
  constexpr std::array separators{',', ';', '\t'};
  std::array<std::size_t, 3> counts{};
  bool quoted = false;
  for (const char c : header) {
    if (c == '"') quoted = !quoted;
    for (std::size_t k = 0; k < separators.size(); ++k) {
      if (!quoted && c == separators[k]) ++counts[k];
    }
  }
  return separators[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) -
                                             counts.begin())];
}

std::string_view trim(std::string_view text, char separator) noexcept {
  while (!text.empty() && is_blank(text.front(), separator)) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back(), separator)) text.remove_suffix(1);
  return text;
}

const char* field_end(const char* first, const char* last, char separator) noexcept {
  while (first != last && is_blank(*first, separator)) ++first;
  if (first != last && *first == '"') {
    bool quoted = true;
    for (++first; first != last && (quoted || *first != separator); ++first) {
      if (*first == '"') quoted = !quoted;
    }
    return first;
  }
  const void* const found =
      first == last ? nullptr : std::memchr(first, separator, static_cast<std::size_t>(last - first));
  return found == nullptr ? last : static_cast<const char*>(found);
}

std::vector<std::string_view> split_fields(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  const char* const last = line.data() + line.size();
  const char* first = line.data();
  while (true) {
    const char* const end = field_end(first, last, separator);
    fields.push_back(trim({first, static_cast<std::size_t>(end - first)}, separator));
    if (end == last) return fields;
    first = end + 1;
  }
}

std::optional<std::string> unquoted(std::string_view field) {
  if (field.empty() || field.front() != '"') return std::string(field);
  std::string text;
  for (std::size_t k = 1; k < field.size(); ++k) {
    if (field[k] != '"') {
      text += field[k];
    } else if (k + 1 < field.size() && field[k + 1] == '"') {
      text += field[k++];
    } else if (k + 1 == field.size()) {
      return text;
    } else {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

bool is_skipped(std::string_view line) noexcept {
  const auto first = line.find_first_not_of(" \t");
  return first == std::string_view::npos || line[first] == '#';
}

}  // namespace proofmass
