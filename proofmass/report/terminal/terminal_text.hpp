// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "proofmass/report/terminal/terminal.hpp"
#include "proofmass/report/terminal/text_table.hpp"

namespace proofmass {

// Builds the text of a terminal report, coloured where the style allows, in lines as wide as it says.
class TerminalText {
 public:
  explicit TerminalText(const TerminalStyle& style) : style_(style) {}
  void heading(std::string_view text);  // bold, after an empty line unless it comes first
  void line(std::string_view text);     // broken at words
  void warning(std::string_view text);  // likewise, yellow
  void table(const TextTable& table);   // its header dimmed; in parts where it is too wide
  // Its first columns alone, as far as the width goes; says so when there are more.
  void first_columns(const TextTable& table);
  [[nodiscard]] const std::string& text() const noexcept { return text_; }
  [[nodiscard]] Language language() const noexcept { return style_.language; }
  [[nodiscard]] std::string in(const Words& words) const { return std::string(words.in(style_.language)); }

 private:
  void coloured(std::string_view escape, std::string_view text);
  void rows(const TextTable& table);
  TerminalStyle style_;
  std::string text_;
};

}  // namespace proofmass
