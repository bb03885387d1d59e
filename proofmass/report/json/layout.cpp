// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/json/layout.hpp"

#include <vector>

namespace proofmass {
namespace {

// Length of the string literal that starts at `at`, quotes included.
std::size_t literal_length(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2U : 1U;
  return end + 1 - at;
}

// Whether the bracket at `at` closes without another opening inside.
bool is_flat_array(std::string_view text, std::size_t at) {
  if (text[at] != '[') return false;
  for (std::size_t k = at + 1; k < text.size(); ++k) {
    if (text[k] == '"') {
      k += literal_length(text, k) - 1;
    } else if (text[k] == '[' || text[k] == '{') {
      return false;
    } else if (text[k] == ']') {
      return true;
    }
  }
  return false;
}

}  // namespace

std::string json_layout(std::string_view text) {
  std::string out;
  std::vector<bool> flat;  // of each open bracket
  const auto new_line = [&] { out.append("\n").append(2 * flat.size(), ' '); };
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '"') {
      const std::size_t length = literal_length(text, k);
      out.append(text.substr(k, length));
      k += length - 1;
    } else if (c == '{' || c == '[') {
      const bool empty = k + 1 < text.size() && (text[k + 1] == '}' || text[k + 1] == ']');
      flat.push_back(empty || is_flat_array(text, k));
      out += c;
      if (!flat.back()) new_line();
    } else if (c == '}' || c == ']') {
      const bool was_flat = flat.back();
      flat.pop_back();
      if (!was_flat) new_line();
      out += c;
    } else if (c == ',') {
      out += c;
      if (flat.back()) {
        out += ' ';
      } else {
        new_line();
      }
    } else {
      out += c;
      if (c == ':') out += ' ';
    }
  }
  return out + '\n';
}

}  // namespace proofmass
