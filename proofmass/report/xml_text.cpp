// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/xml_text.hpp"

#include <algorithm>

#include "proofmass/core/utf8.hpp"

namespace proofmass {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

std::string_view entity_of(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

// Tab and new line apart.
bool is_control(char c) {
  constexpr unsigned char kFirstPrintable = 0x20, kDelete = 0x7F;
  const auto byte = static_cast<unsigned char>(c);
  return (byte < kFirstPrintable && c != '\t' && c != '\n') || byte == kDelete;
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const std::string_view entity = entity_of(text.front());
    if (!entity.empty()) {
      out += entity;
    } else if (length == 0 || is_control(text.front())) {
      out += kReplacement;
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

}  // namespace proofmass
