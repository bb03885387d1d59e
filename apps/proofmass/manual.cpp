// SPDX-License-Identifier: Apache-2.0
#include "manual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>
#include <vector>

#include "completion/options_shown.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/core/nearest.hpp"
#include "proofmass/core/version.hpp"

namespace proofmass::cli {
namespace {

// Text as man takes it: no hyphen becomes a dash, no line begins a request.
std::string escaped(std::string_view text) {
  std::string result;
  bool line_start = true;
  for (const char c : text) {
    if (line_start && (c == '.' || c == '\'')) result += "\\&";
    if (c == '-' || c == '\\') result += '\\';
    result += c == '\\' ? "e" : std::string(1, c);
    line_start = c == '\n';
  }
  return result;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string head(const std::string& name, const std::string& description) {
  return fmt::format(".TH {} 1 \"\" \"proofmass {}\" \"Proofmass\"\n.SH NAME\n{} \\- {}\n", upper(name),
                     version(), escaped(name), escaped(description));
}

std::string as_typed(const std::string& text) { return ".nf\n" + escaped(text) + "\n.fi\n"; }

// Each line of a help as a line of its own.
std::string paragraphs(const std::string& help) {
  std::string text;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    if (!text.empty()) text += ".br\n";
    text += escaped(line.substr(std::min(line.find_first_not_of(' '), line.size()))) + "\n";
  }
  return text;
}

std::string options(const CLI::App& verb) {
  std::string text;
  std::string group;
  for (const ShownOption& option : options_shown(verb)) {
    if (option.group != group) text += fmt::format(".SH {}\n", upper(option.group));
    group = option.group;
    text += fmt::format(".TP\n.B {}{}\n{}", escaped(option.name),
                        option.type.empty() ? "" : " " + escaped(option.type), paragraphs(option.help));
  }
  return text;
}

std::string of_program(const CLI::App& app) {
  std::string text = head("proofmass", app.get_description());
  text += ".SH SYNOPSIS\n.B proofmass\nVERB [OPTIONS] FILE...\n.SH VERBS\n";
  for (const CLI::App* const verb : app.get_subcommands({})) {
    text +=
        fmt::format(".TP\n.BR proofmass\\-{} (1)\n{}\n", verb->get_name(), escaped(verb->get_description()));
  }
  return text + ".SH EXIT STATUS\n" + as_typed(app.get_footer());
}

std::string of_verb(const CLI::App& verb) {
  std::string text = head("proofmass-" + verb.get_name(), verb.get_description());
  text += fmt::format(".SH SYNOPSIS\n.B proofmass {}\n[OPTIONS]", verb.get_name());
  for (const CLI::Option* const option : verb.get_options()) {
    if (!option->get_positional()) continue;
    const std::string name = escaped(option->get_name(true));
    text += option->get_required() ? " " + name : " [" + name + "]";
  }
  return text + "\n" + options(verb) + ".SH EXAMPLES\n" + as_typed(verb.get_footer()) +
         ".SH SEE ALSO\n.BR proofmass (1)\n";
}

}  // namespace

std::string manual_page(const CLI::App& app, std::string_view name) {
  if (name.empty()) return of_program(app);
  for (const CLI::App* const verb : app.get_subcommands({})) {
    if (verb->get_name() == name) return of_verb(*verb);
  }
  const std::vector<std::string> names = verb_names(app);
  throw usage_error(message("manual: unknown verb '{}'{}", excerpt(name),
                            did_you_mean(name, std::vector<std::string_view>(names.begin(), names.end()))));
}

}  // namespace proofmass::cli
