// SPDX-License-Identifier: Apache-2.0
#include "complaint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "proofmass/core/nearest.hpp"
#include "proofmass/report/text/endings.hpp"
#include "proofmass/report/text/findings.hpp"
#include "proofmass/report/text/messages/message_text.hpp"

namespace proofmass::cli {
namespace {

constexpr Words kError{"error: ", "错误："};
constexpr Words kEnded{"ended: ", "终止："};
constexpr Words kTry{"try: ", "可尝试："};
constexpr Words kOr{" or ", " 或 "};

// Quoted where a shell would take it apart.
std::string for_the_shell(const std::string& word) {
  const bool plain =
      word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_=,.+-/:@%") ==
      std::string::npos;
  if (plain) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string as_flags(const std::vector<Remedy>& remedies, Language language) {
  std::string flags;
  for (const Remedy& remedy : remedies) {
    const std::string value = !remedy.value.empty()      ? remedy.value
                              : remedy.option == "terms" ? "K0,Ki,..."
                                                         : "X";
    if (!flags.empty()) flags += remedy.with_previous ? " " : kOr.in(language);
    flags += fmt::format("--{} {}", remedy.option, for_the_shell(value));
  }
  return flags;
}

// What stands between the places of a pattern, and before and after them.
std::vector<std::string_view> pieces_of(std::string_view words) {
  std::vector<std::string_view> pieces;
  std::size_t from = 0;
  for (MessagePlace place = next_place(words, 0); place.found(); place = next_place(words, from)) {
    pieces.push_back(words.substr(from, place.begin - from));
    from = place.end;
  }
  pieces.push_back(words.substr(from));
  return pieces;
}

// A sentence of CLI11's, which it makes itself, as the pattern and its values if it has that form.
std::optional<Message> as_pattern(std::string_view text, const Message& pattern) {
  const std::vector<std::string_view> pieces = pieces_of(pattern.words());
  if (!text.starts_with(pieces.front()) || !text.ends_with(pieces.back())) return std::nullopt;
  std::vector<Message> values;
  std::size_t at = pieces.front().size();
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    const bool last = k + 1 == pieces.size();
    const std::size_t end = last ? text.size() - pieces[k].size() : text.find(pieces[k], at);
    if (end == std::string_view::npos || end < at) return std::nullopt;
    values.push_back(Message::verbatim(text.substr(at, end - at)));
    at = end + pieces[k].size();
  }
  if (at != text.size()) return std::nullopt;
  return Message(pattern.words(), std::move(values));
}

Message parser_message(std::string_view text) {
  static const std::array kPatterns{Message("The following argument was not expected: {}"),
                                    Message("The following arguments were not expected: {}"),
                                    Message("A subcommand is required"),
                                    Message("{} is required"),
                                    Message("{}: {} required {} missing"),
                                    Message("{}: At least {} required but received {}"),
                                    Message("{}: At Most {} required but received {}"),
                                    Message("Expected exactly {} arguments to {}, got {}"),
                                    Message("Expected at least {} arguments to {}, got {}"),
                                    Message("{} was given a disallowed flag override"),
                                    Message("{}: too many inputs for a flag"),
                                    Message("{}: Should be true/false or a number"),
                                    Message("Could not convert: {} = {}"),
                                    Message("{} requires {}"),
                                    Message("{} excludes {}")};
  for (const Message& pattern : kPatterns) {
    if (auto made = as_pattern(text, pattern)) return *std::move(made);
  }
  return Message::verbatim(text);
}

}  // namespace

Language language_of(std::span<const std::string> words) {
  constexpr std::string_view kOption = "--lang";
  Language language = Language::en;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string_view word = words[k];
    if (!word.starts_with(kOption)) continue;
    const std::string_view rest = word.substr(kOption.size());
    const std::string_view value = rest.empty() && k + 1 < words.size() ? std::string_view(words[k + 1])
                                   : rest.starts_with('=')              ? rest.substr(1)
                                                                        : std::string_view();
    if (value == "zh") language = Language::zh;
    if (value == "en") language = Language::en;
  }
  return language;
}

std::string complaint(const Error& error, Language language) {
  std::string text = "proofmass: ";
  text.append(kError.in(language)).append(message_text(error.message(), language));
  for (const Finding& finding : error.findings()) text.append("\n  ").append(sentence(finding, language));
  if (!error.ending().empty())
    text.append("\n  ").append(kEnded.in(language)).append(sentence(error.ending(), language));
  const std::string flags = as_flags(error.remedies(), language);
  if (!flags.empty()) text.append("\n").append(kTry.in(language)).append(flags);
  return text.append("\n");
}

void complain(const std::string& text) noexcept { std::fputs(text.c_str(), stderr); }

Error misused(const CLI::ParseError& error, const CLI::App& app, std::span<const std::string> words) {
  std::string page = "proofmass --help";
  Message meant;
  for (const CLI::App* verb : app.get_subcommands({})) {
    if (verb->get_name() != words.front()) continue;
    page = fmt::format("proofmass {} --help", verb->get_name());
    std::vector<std::string> names;
    for (const CLI::Option* option : verb->get_options()) {
      if (!option->get_group().empty()) names.push_back(option->get_name());
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    for (const std::string_view word : words.subspan(1)) {
      if (!word.starts_with("--") || std::find(views.begin(), views.end(), word) != views.end()) continue;
      if (meant.empty()) meant = did_you_mean(word.substr(0, word.find('=')), views);
    }
  }
  return usage_error(message("{}{} (see {})", parser_message(error.what()), meant, page));
}

}  // namespace proofmass::cli
