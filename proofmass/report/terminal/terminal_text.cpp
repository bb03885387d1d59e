// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/terminal_text.hpp"

#include "proofmass/report/terminal/terminal_words.hpp"
#include "proofmass/report/terminal/with_figures_internal.hpp"
#include "proofmass/report/terminal/wrapped_text.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kIndent = 2;  // of the lines that a long one goes on in

}  // namespace

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

void TerminalText::line(std::string_view text) {
  for (const std::string& part : wrapped_lines(text, style_.width, kIndent)) text_.append(part).append("\n");
}

void TerminalText::warning(std::string_view text) {
  for (const std::string& part : wrapped_lines(text, style_.width, kIndent)) coloured("\x1b[33m", part);
}

void TerminalText::rows(const TextTable& table) {
  bool header = true;
  for (const std::string& row : table.lines(style_.width)) {
    header ? coloured("\x1b[2m", row) : void(text_.append(row).append("\n"));
    header = false;
  }
}

void TerminalText::table(const TextTable& table) {
  bool first = true;
  for (const TextTable& part : table.parts(style_.width)) {
    if (!first) text_ += '\n';
    rows(part);
    first = false;
  }
}

void TerminalText::first_columns(const TextTable& table) {
  const TextTable fitting = table.fitting(style_.width);
  rows(fitting);
  if (fitting.columns() < table.columns()) {
    const auto names = table.header().subspan(fitting.columns());
    const std::string how = style_.more_columns.empty()
                                ? ""
                                : with_figures({" ({})", "（{}）"}, style_.language, style_.more_columns);
    std::string list;
    for (const std::string& name : names) list.append(list.empty() ? "" : in({", ", "、"})).append(name);
    line(with_figures({"not shown in {} columns: {}{}", "{} 列宽度内未显示：{}{}"}, style_.language,
                      style_.width, list, how));
  }
}

}  // namespace proofmass
