// SPDX-License-Identifier: Apache-2.0
#include "help_text.hpp"

#include <algorithm>
#include <cstddef>
#include <sstream>

#include "proofmass/report/terminal/wrapped_text.hpp"

namespace proofmass::cli {
namespace {

constexpr std::size_t kWidth = 80;
constexpr std::size_t kColumn = 26;  // where explanations begin

// "  --seed N    Seed of …", the explanation below a name that is too long.
std::string entry(const std::string& name, const std::string& explanation) {
  std::string text = "  " + name;
  if (explanation.empty()) return text + "\n";
  const std::string margin(kColumn, ' ');
  text = text.size() + 2 > kColumn ? text + "\n" + margin : text + margin.substr(text.size());
  bool first = true;
  std::istringstream paragraphs(explanation);
  for (std::string paragraph; std::getline(paragraphs, paragraph);) {
    for (const std::string& line : wrapped_lines(paragraph, kWidth - kColumn, first ? 0 : 2)) {
      text.append(first ? "" : margin).append(line).append("\n");
      first = false;
    }
  }
  return text;
}

}  // namespace

std::string HelpText::make_option(const CLI::Option* option, bool is_positional) const {
  const std::string type = is_positional || option->get_type_size() == 0 ? "" : " " + option->get_type_name();
  return entry(option->get_name(is_positional, true) + type, option->get_description());
}

std::string HelpText::make_description(const CLI::App* app) const {
  std::string text;
  for (const std::string& line : wrapped_lines(app->get_description(), kWidth)) text += line + "\n";
  return text;
}

std::string HelpText::make_subcommand(const CLI::App* verb) const {
  return entry(verb->get_name(), verb->get_description());
}

}  // namespace proofmass::cli
