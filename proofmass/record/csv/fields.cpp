// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/fields.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace proofmass {

namespace {

// A character beyond ASCII and what it looks like.
struct LookAlike {
  std::string_view character;
  char plain;
};
constexpr std::array kLookAlikes{
    LookAlike{"\u2212", '-'},  // minus sign
    LookAlike{"\u2013", '-'},  // en dash
    LookAlike{"\uFE63", '-'},  // small hyphen-minus
    LookAlike{"\u00A0", ' '},  // no-break space
    LookAlike{"\u2007", ' '},  // figure space
    LookAlike{"\u2009", ' '},  // thin space
    LookAlike{"\u202F", ' '},  // narrow no-break space
    LookAlike{"\u3000", ' '},  // ideographic space
};

// U+FF01 to U+FF5E are the printable characters of ASCII, full-width. In UTF-8: EF BC 81 to EF BD 9E.
std::optional<char> fullwidth(std::string_view text) noexcept {
  if (text.size() < 3 || text[0] != '\xEF' || (text[1] != '\xBC' && text[1] != '\xBD')) return std::nullopt;
  const auto last = static_cast<unsigned char>(text[2]);
  const unsigned code = (text[1] == '\xBC' ? 0U : 0x40U) + (last - 0x80U) + 0x20U;
  if (last < 0x80 || code < 0x21 || code > 0x7E) return std::nullopt;
  return static_cast<char>(code);
}

}  // namespace

char detect_separator(std::string_view header) noexcept {
  constexpr std::array separators{',', ';', '\t', '|'};
  std::array<std::size_t, separators.size()> counts{};
  std::size_t blanks = 0;  // between words
  bool quoted = false;
  int depth = 0;
  for (std::size_t at = 0; at < header.size(); ++at) {
    const char c = header[at];
    if (c == '"') quoted = !quoted;
    if (c == '[' || c == '(') ++depth;
    if (c == ']' || c == ')') --depth;
    if (quoted || depth > 0) continue;
    for (std::size_t k = 0; k < separators.size(); ++k) {
      if (c == separators[k]) ++counts[k];
    }
    if (c == ' ' && at > 0 && header[at - 1] != ' ' &&
        header.find_first_not_of(' ', at) != std::string_view::npos)
      ++blanks;
  }
  const auto* const most = std::max_element(counts.begin(), counts.end());
  if (*most == 0) return blanks > 0 ? ' ' : ',';
  return separators[static_cast<std::size_t>(most - counts.begin())];
}

std::string plain_characters(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  while (!text.empty()) {
    if (static_cast<unsigned char>(text.front()) < 0x80) {
      plain += text.front();
      text.remove_prefix(1);
      continue;
    }
    const auto same = [text](const LookAlike& one) { return text.starts_with(one.character); };
    const auto* const found = std::find_if(kLookAlikes.begin(), kLookAlikes.end(), same);
    if (found != kLookAlikes.end()) {
      plain += found->plain;
      text.remove_prefix(found->character.size());
    } else if (const auto wide = fullwidth(text)) {
      plain += *wide;
      text.remove_prefix(3);
    } else {
      plain += text.front();
      text.remove_prefix(1);
    }
  }
  return plain;
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

}  // namespace proofmass
