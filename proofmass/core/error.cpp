// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <system_error>

#include "proofmass/core/utf8.hpp"

namespace proofmass {
namespace {

// The next character of `text`, ready for display: itself when printable, otherwise its bytes as \xNN.
std::string printable(std::string_view character) {
  const auto first = static_cast<unsigned char>(character.front());
  const bool control = character.size() == 1 && (first < 0x20 || first == 0x7F);
  const bool c1_control =
      character.size() == 2 && first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;
  const bool stray = character.size() == 1 && first >= 0x80;
  if (!control && !c1_control && !stray) return std::string(character);
  std::string escaped;
  for (const char byte : character) escaped += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
  return escaped;
}

}  // namespace

std::string excerpt(std::string_view text, std::size_t most) {
  std::string shown;
  for (std::size_t count = 0; !text.empty(); ++count) {
    if (count == most) return shown + "...";
    const std::size_t length = std::max<std::size_t>(1, utf8_length(text));
    shown += printable(text.substr(0, length));
    text.remove_prefix(length);
  }
  return shown;
}

Error bad_data(const Place& place, const FoundText& found, const Message& expected,
               std::vector<Remedy> remedies) {
  Message said = found.words.empty() ? message("expected {}", expected)
                                     : message("found '{}', expected {}", found.words, expected);
  if (!place.column.empty()) {
    said = message("{}: {}",
                   place.is_key ? message("key '{}'", excerpt(place.column))
                                : message("column '{}'", excerpt(place.column)),
                   said);
  }
  const Message where =
      place.row > 0 ? message("{}:{}", place.file, place.row) : Message::verbatim(place.file);
  return {ErrorKind::bad_data, message("{}: {}", where, said), std::move(remedies)};
}

Message system_reason(int error_number) {
  return Message::foreign(std::generic_category().message(error_number));
}

Error cannot_open(std::string_view file, int error_number) {
  std::string reason = std::generic_category().message(error_number);
  if (!reason.empty())
    reason.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(reason.front())));
  return {ErrorKind::bad_data, message("cannot open {}: {}", file, Message::foreign(reason))};
}

Error usage_error(const Message& message) { return {ErrorKind::usage, message}; }

Error refusal(const Message& message, std::vector<Remedy> remedies, std::vector<Finding> findings) {
  return {ErrorKind::refused, message, std::move(remedies), std::move(findings)};
}

int exit_code(ErrorKind kind) noexcept {
  switch (kind) {
    case ErrorKind::internal:
      return 1;
    case ErrorKind::usage:
      return 2;
    case ErrorKind::bad_data:
      return 3;
    case ErrorKind::refused:
      return 4;
    case ErrorKind::interrupted:
      return 130;
  }
  return 1;
}

}  // namespace proofmass
