// SPDX-License-Identifier: Apache-2.0
#include "options_shown.hpp"

#include <sstream>

#include "proofmass/identify/method.hpp"

namespace proofmass::cli {
namespace {

// "a|b|c"; of methods, their names. A word in capitals stands for a value of any kind.
std::vector<std::string> choices_of(const std::string& type) {
  std::vector<std::string> choices;
  if (type == "METHOD") {
    for (const Method& method : methods()) choices.emplace_back(info(method).name);
    return choices;
  }
  if (type.find('|') == std::string::npos) return choices;
  std::istringstream words(type);
  for (std::string word; std::getline(words, word, '|');) {
    if (word.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string::npos) choices.push_back(word);
  }
  return choices;
}

}  // namespace

std::vector<ShownOption> options_shown(const CLI::App& verb) {
  std::vector<ShownOption> shown;
  for (const CLI::Option* const option : verb.get_options()) {
    if (option->get_group().empty() || option->get_positional()) continue;
    const std::string type = option->get_type_size() == 0 ? "" : option->get_type_name();
    shown.push_back({.name = "--" + option->get_lnames().front(),
                     .type = type,
                     .help = option->get_description(),
                     .group = option->get_group(),
                     .choices = choices_of(type)});
  }
  return shown;
}

}  // namespace proofmass::cli
