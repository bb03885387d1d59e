// SPDX-License-Identifier: Apache-2.0
#include "proofmass/record/csv/encoding.hpp"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/core/utf8.hpp"

namespace proofmass {
namespace {

constexpr std::array<std::string_view, 5> kLabels{"UTF-8", "UTF-16LE", "UTF-16BE", "GB18030", "Windows-1252"};

// Other names, in lower case and without hyphens and underscores.
constexpr std::array kAliases{
    std::pair<std::string_view, Encoding>{"utf8", Encoding::utf8},
    std::pair<std::string_view, Encoding>{"ascii", Encoding::utf8},
    std::pair<std::string_view, Encoding>{"utf16", Encoding::utf16le},
    std::pair<std::string_view, Encoding>{"utf16le", Encoding::utf16le},
    std::pair<std::string_view, Encoding>{"utf16be", Encoding::utf16be},
    std::pair<std::string_view, Encoding>{"gb18030", Encoding::gb18030},
    std::pair<std::string_view, Encoding>{"gbk", Encoding::gb18030},
    std::pair<std::string_view, Encoding>{"gb2312", Encoding::gb18030},
    std::pair<std::string_view, Encoding>{"cp936", Encoding::gb18030},
    std::pair<std::string_view, Encoding>{"windows936", Encoding::gb18030},
    std::pair<std::string_view, Encoding>{"windows1252", Encoding::windows1252},
    std::pair<std::string_view, Encoding>{"cp1252", Encoding::windows1252},
    std::pair<std::string_view, Encoding>{"latin1", Encoding::windows1252},
    std::pair<std::string_view, Encoding>{"iso88591", Encoding::windows1252},
    std::pair<std::string_view, Encoding>{"ansi", Encoding::windows1252},
};

const char* converter_name(Encoding encoding) noexcept {
  return encoding == Encoding::windows1252 ? "CP1252" : kLabels[static_cast<std::size_t>(encoding)].data();
}

unsigned byte_at(std::string_view text, std::size_t k) noexcept {
  return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U;
}

// Zeros among the even and among the odd bytes.
std::pair<std::size_t, std::size_t> zeros(std::string_view bytes) noexcept {
  std::pair<std::size_t, std::size_t> count{0, 0};
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    if (bytes[k] == '\0') ++(k % 2 == 0 ? count.first : count.second);
  }
  return count;
}

}  // namespace

std::string_view to_string(Encoding encoding) noexcept { return kLabels[static_cast<std::size_t>(encoding)]; }

std::optional<Encoding> find_encoding(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    if (c != '-' && c != '_' && c != ' ')
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  for (const auto& [alias, encoding] : kAliases) {
    if (alias == plain) return encoding;
  }
  return std::nullopt;
}

std::string known_encodings() {
  std::string list;
  for (const std::string_view name : kLabels) list.append(list.empty() ? "" : ", ").append(name);
  return list;
}

std::optional<Encoding> encoding_by_mark(std::string_view first_bytes) noexcept {
  if (first_bytes.starts_with("\xEF\xBB\xBF")) return Encoding::utf8;
  if (first_bytes.starts_with("\xFF\xFE")) return Encoding::utf16le;
  if (first_bytes.starts_with("\xFE\xFF")) return Encoding::utf16be;
  const std::string_view sample = first_bytes.substr(0, std::min<std::size_t>(first_bytes.size(), 256));
  const auto [even, odd] = zeros(sample);
  // Every other byte of Latin text is zero; of Chinese text in a header, fewer.
  if (sample.size() >= 4 && odd > sample.size() / 4 && even == 0) return Encoding::utf16le;
  if (sample.size() >= 4 && even > sample.size() / 4 && odd == 0) return Encoding::utf16be;
  return std::nullopt;
}

Encoding encoding_by_content(std::string_view text) noexcept {
  if (is_utf8(text)) return Encoding::utf8;
  std::size_t words = 0;   // characters of GB2312, two bytes each
  std::size_t single = 0;  // anything else beyond ASCII
  const auto is_letter = [text](std::size_t k) {
    return k < text.size() && std::isalpha(static_cast<unsigned char>(text[k])) != 0 &&
           byte_at(text, k) < 0x80;
  };
  for (std::size_t k = 0; k < text.size();) {
    if (byte_at(text, k) < 0x80) {
      ++k;
      continue;
    }
    std::size_t end = k;
    while (byte_at(text, end) >= 0xA1 && byte_at(text, end) <= 0xF7 && byte_at(text, end + 1) >= 0xA1)
      end += 2;
    // A lone pair inside a word is two letters: "Gr\xF6\xDF" "e".
    const bool letters = end == k + 2 && ((k > 0 && is_letter(k - 1)) || is_letter(end));
    if (end == k || letters) {
      ++single;
      ++k;
      if (letters) ++single, ++k;
    } else {
      words += (end - k) / 2;
      k = end;
    }
  }
  return words > single ? Encoding::gb18030 : Encoding::windows1252;
}

bool is_ascii(std::string_view text) noexcept {
  unsigned char found = 0;  // no early exit: the compiler then vectorises the loop
  for (const char c : text) found = static_cast<unsigned char>(found | static_cast<unsigned char>(c));
  return found < 0x80;
}

void Decoder::Close::operator()(void* converter) const noexcept { iconv_close(converter); }

Decoder::Decoder(Encoding encoding) : converter_(iconv_open("UTF-8", converter_name(encoding))) {
  // iconv_open returns -1, not null, when the C library does not know the encoding.
  // NOLINTNEXTLINE(performance-no-int-to-ptr,cppcoreguidelines-pro-type-reinterpret-cast)
  if (converter_.get() == reinterpret_cast<void*>(-1)) {
    (void)converter_.release();
    throw bad_data({.file = std::string(to_string(encoding))}, "",
                   "an encoding that the system's C library can convert");
  }
}

std::optional<std::string> Decoder::decode(std::string_view bytes) {
  std::string input = std::move(rest_);
  input.append(bytes);
  rest_.clear();
  std::string output(input.size() * 3 + 16, '\0');  // no byte becomes more than three
  char* from = input.data();
  std::size_t left = input.size();
  char* to = output.data();
  std::size_t room = output.size();
  if (iconv(converter_.get(), &from, &left, &to, &room) == static_cast<std::size_t>(-1)) {
    if (errno != EINVAL) return std::nullopt;
    rest_.assign(from, left);
  }
  output.resize(output.size() - room);
  return output;
}

}  // namespace proofmass
