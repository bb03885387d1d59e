// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "completion/completion.hpp"
#include "completion/options_shown.hpp"

namespace proofmass::cli {
namespace {

// Within single quotes, and there within a specification: `marks` would end a part of it.
std::string zsh_escaped(std::string_view text, std::string_view marks) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += R"('\'')";
      continue;
    }
    if (c == '\\' || marks.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

// ":N: " where nothing can be offered.
std::string zsh_value(const ShownOption& option) {
  if (option.takes == Takes::nothing) return "";
  const std::string choices = fmt::format("{}", fmt::join(option.choices, " "));
  std::string action = " ";
  if (option.takes == Takes::one_of) action = fmt::format("({})", choices);
  if (option.takes == Takes::list_of) action = fmt::format("_values -s , value {}", choices);
  if (option.takes == Takes::file) action = "_files";
  if (option.takes == Takes::folder) action = "_files -/";
  return fmt::format(":{}:{}", option.choices.empty() ? zsh_escaped(option.type, ":") : "value", action);
}

}  // namespace

std::string zsh_completion(const CLI::App& app) {
  std::string text = "#compdef proofmass\n_proofmass() {\n  local -a verbs\n  verbs=(\n";
  std::string cases;
  for (const CLI::App* const verb : app.get_subcommands({})) {
    text +=
        fmt::format("    '{}:{}'\n", verb->get_name(), zsh_escaped(first_line(verb->get_description()), ""));
    cases += fmt::format("    {})\n      _arguments", verb->get_name());
    for (const ShownOption& option : options_shown(*verb)) {
      cases +=
          fmt::format(" \\\n        '{}{}[{}]{}'", option.name, option.takes == Takes::nothing ? "" : "=",
                      zsh_escaped(first_line(option.help), "[]"), zsh_value(option));
    }
    for (const ShownOption& argument : arguments_shown(*verb))
      cases += fmt::format(" \\\n        '{}'", zsh_value(argument));
    cases += "\n      ;;\n";
  }
  return text +
         "  )\n  if ((CURRENT == 2)); then\n    _describe verb verbs\n    return\n  fi\n  local "
         "verb=$words[2]\n"
         "  shift words\n  ((CURRENT--))\n  case $verb in\n" +
         cases + "  esac\n}\n_proofmass \"$@\"\n";
}

}  // namespace proofmass::cli
