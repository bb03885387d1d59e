// SPDX-License-Identifier: Apache-2.0
#include "completion/options_shown.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "proofmass/core/term.hpp"
#include "proofmass/identify/method.hpp"

namespace proofmass::cli {
namespace {

// "a|b|c"; a word in capitals stands for a value of any kind.
std::vector<std::string> words_between_bars(const std::string& type) {
  std::vector<std::string> choices;
  if (type.find('|') == std::string::npos) return choices;
  std::istringstream words(type);
  for (std::string word; std::getline(words, word, '|');) {
    if (word.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string::npos) choices.push_back(word);
  }
  return choices;
}

std::vector<std::string> choices_of(const CLI::App& verb, const std::string& type) {
  std::vector<std::string> choices;
  if (type == "METHOD" || type == "A,B,...") {
    for (const Method& method : methods()) choices.emplace_back(info(method).name);
  } else if (type == "K0,Ki,...") {
    for (const Term term : full_terms()) choices.emplace_back(name(term));
  } else if (type == "VERB") {
    choices = verb_names(*verb.get_parent());
  } else {
    choices = words_between_bars(type);
  }
  return choices;
}

// A name with an ending, as RUN.csv, stands for a file; the dots of "A,B,..." are no ending.
bool names_a_file(const std::string& type) {
  const auto dot = type.rfind('.');
  return type == "FILE" || (dot != std::string::npos && dot + 1 < type.size() &&
                            std::isalpha(static_cast<unsigned char>(type[dot + 1])) != 0);
}

Takes taken_by(const std::string& type, bool has_choices) {
  if (type.empty()) return Takes::nothing;
  if (has_choices) return type.ends_with(",...") ? Takes::list_of : Takes::one_of;
  if (type == "DIR") return Takes::folder;
  return names_a_file(type) ? Takes::file : Takes::text;
}

ShownOption shown(const CLI::App& verb, const CLI::Option& option, const std::string& name,
                  const std::string& type) {
  std::vector<std::string> choices = choices_of(verb, type);
  const Takes takes = taken_by(type, !choices.empty());
  return {.name = name,
          .type = type,
          .help = option.get_description(),
          .group = option.get_group(),
          .takes = takes,
          .choices = std::move(choices)};
}

}  // namespace

std::vector<ShownOption> options_shown(const CLI::App& verb) {
  std::vector<ShownOption> options;
  for (const CLI::Option* const option : verb.get_options()) {
    if (option->get_group().empty() || option->get_positional()) continue;
    const std::string type = option->get_type_size() == 0 ? "" : option->get_type_name();
    options.push_back(shown(verb, *option, "--" + option->get_lnames().front(), type));
  }
  return options;
}

std::vector<ShownOption> arguments_shown(const CLI::App& verb) {
  std::vector<ShownOption> arguments;
  for (const CLI::Option* const option : verb.get_options()) {
    if (!option->get_positional()) continue;
    const std::string name = option->get_name(true);
    const std::string type = option->get_type_name();
    arguments.push_back(shown(verb, *option, name, type == "TEXT" ? name : type));
  }
  return arguments;
}

std::vector<std::string> verb_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* const verb : app.get_subcommands({})) names.push_back(verb->get_name());
  return names;
}

std::string first_line(const std::string& text) {
  std::string line = text.substr(0, text.find('\n'));
  if (line.ends_with(':')) line.pop_back();
  return line;
}

}  // namespace proofmass::cli
