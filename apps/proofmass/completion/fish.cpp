// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "completion/completion.hpp"
#include "completion/options_shown.hpp"

namespace proofmass::cli {
namespace {

// fish's own functions; C++ keeps such names to itself, but not in two parts.
constexpr std::string_view kNoVerbYet =
    "_"
    "_fish_use_subcommand";
constexpr std::string_view kVerbSeen =
    "_"
    "_fish_seen_subcommand_from";
constexpr std::string_view kAppend =
    "_"
    "_fish_append";
constexpr std::string_view kFolders =
    "_"
    "_fish_complete_directories";

// Within single quotes.
std::string fish_escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\' || c == '\'') result += '\\';
    result += c;
  }
  return result;
}

// What follows an option's name: -x takes a value and no file, -r -F a file.
std::string fish_value(const ShownOption& option) {
  const std::string choices = fmt::format("{}", fmt::join(option.choices, " "));
  switch (option.takes) {
    case Takes::nothing:
      return "";
    case Takes::text:
      return " -x";
    case Takes::one_of:
      return fmt::format(" -x -a '{}'", choices);
    case Takes::list_of:
      return fmt::format(" -x -a '({} , {})'", kAppend, choices);
    case Takes::file:
      return " -r -F";
    case Takes::folder:
      return fmt::format(" -x -a '({})'", kFolders);
  }
  return "";
}

}  // namespace

std::string fish_completion(const CLI::App& app) {
  std::string text;
  for (const CLI::App* const verb : app.get_subcommands({})) {
    text += fmt::format("complete -c proofmass -n {} -f -a {} -d '{}'\n", kNoVerbYet, verb->get_name(),
                        fish_escaped(first_line(verb->get_description())));
    const std::string condition = fmt::format("complete -c proofmass -n '{} {}", kVerbSeen, verb->get_name());
    for (const ShownOption& option : options_shown(*verb)) {
      text += fmt::format("{}' -l {}{} -d '{}'\n", condition, option.name.substr(2), fish_value(option),
                          fish_escaped(first_line(option.help)));
    }
    const std::vector<ShownOption> arguments = arguments_shown(*verb);
    if (arguments.empty()) text += condition + "' -f\n";
    for (const ShownOption& argument : arguments) {
      if (argument.takes == Takes::one_of)
        text += fmt::format("{}' -f -a '{}'\n", condition, fmt::join(argument.choices, " "));
    }
  }
  return text;
}

}  // namespace proofmass::cli
