// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/terminal_text.hpp"

namespace proofmass {

void TerminalText::coloured(std::string_view escape, std::string_view text) {
  if (style_.colour) text_ += escape;
  text_ += text;
  if (style_.colour) text_ += "\x1b[0m";
  text_ += '\n';
}

void TerminalText::heading(std::string_view text) {
  if (!text_.empty()) text_ += '\n';
  coloured("\x1b[1m", text);
}

void TerminalText::line(std::string_view text) { text_.append(text).append("\n"); }

void TerminalText::warning(std::string_view text) { coloured("\x1b[33m", text); }

void TerminalText::table(const TextTable& table) {
  bool header = true;
  for (const std::string& row : table.lines()) {
    header ? coloured("\x1b[2m", row) : line(row);
    header = false;
  }
}

}  // namespace proofmass
