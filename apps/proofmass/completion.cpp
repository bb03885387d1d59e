// SPDX-License-Identifier: Apache-2.0
#include "completion.hpp"

#include <fmt/format.h>

#include <vector>

#include "options_shown.hpp"
#include "proofmass/core/error.hpp"

namespace proofmass::cli {
namespace {

// fish's own functions.
constexpr std::string_view kNoVerbYet =
    "_"
    "_fish_use_subcommand";
constexpr std::string_view kVerbSeen =
    "_"
    "_fish_seen_subcommand_from";

// The first line of a text, without what would end a quoted word of a shell.
std::string plain(const std::string& text) {
  std::string line;
  for (const char c : text.substr(0, text.find('\n'))) {
    if (std::string_view("'[]:\\`$").find(c) == std::string_view::npos) line += c;
  }
  return line;
}

std::string verb_names(const CLI::App& app) {
  std::string names;
  for (const CLI::App* const verb : app.get_subcommands({})) names += verb->get_name() + " ";
  return names + "help";
}

std::string bash(const CLI::App& app) {
  std::string values;
  std::string options;
  for (const CLI::App* const verb : app.get_subcommands({})) {
    std::string names;
    for (const ShownOption& option : options_shown(*verb)) {
      names.append(names.empty() ? "" : " ").append(option.name);
      if (option.choices.empty()) continue;
      values += fmt::format("    {}:{}) words='{}' ;;\n", verb->get_name(), option.name,
                            fmt::join(option.choices, " "));
    }
    options += fmt::format("      {}) words='{}' ;;\n", verb->get_name(), names);
  }
  return fmt::format(R"(# bash completion of proofmass
_proofmass() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}} words=
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W '{} --help --version' -- "$current")
    return
  fi
  case ${{COMP_WORDS[1]}}:$previous in
{}    help:help) words='{}' ;;
  esac
  if [[ -z $words && $current == -* ]]; then
    case ${{COMP_WORDS[1]}} in
{}    esac
  fi
  if [[ -n $words ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
  fi
}}
complete -o filenames -F _proofmass proofmass
)",
                     verb_names(app), values, verb_names(app), options);
}

std::string zsh(const CLI::App& app) {
  std::string text = "#compdef proofmass\n_proofmass() {\n  local -a verbs\n  verbs=(\n";
  std::string cases;
  for (const CLI::App* const verb : app.get_subcommands({})) {
    text += fmt::format("    '{}:{}'\n", verb->get_name(), plain(verb->get_description()));
    cases += fmt::format("    {})\n      _arguments \\\n", verb->get_name());
    for (const ShownOption& option : options_shown(*verb)) {
      const std::string value = option.type.empty() ? ""
                                : option.choices.empty()
                                    ? ":" + plain(option.type) + ":_files"
                                    : fmt::format(":value:({})", fmt::join(option.choices, " "));
      cases += fmt::format("        '{}[{}]{}' \\\n", option.name, plain(option.help), value);
    }
    cases += "        '*:file:_files'\n      ;;\n";
  }
  return text +
         "  )\n  if ((CURRENT == 2)); then\n    _describe verb verbs\n    return\n  fi\n  local "
         "verb=$words[2]\n"
         "  shift words\n  ((CURRENT--))\n  case $verb in\n" +
         cases + "  esac\n}\n_proofmass \"$@\"\n";
}

std::string fish(const CLI::App& app) {
  std::string text;
  for (const CLI::App* const verb : app.get_subcommands({})) {
    text += fmt::format("complete -c proofmass -n {} -f -a {} -d '{}'\n", kNoVerbYet, verb->get_name(),
                        plain(verb->get_description()));
    for (const ShownOption& option : options_shown(*verb)) {
      const std::string value = option.type.empty() ? ""
                                : option.choices.empty()
                                    ? " -r"
                                    : fmt::format(" -x -a '{}'", fmt::join(option.choices, " "));
      text += fmt::format("complete -c proofmass -n '{} {}' -l {}{} -d '{}'\n", kVerbSeen, verb->get_name(),
                          option.name.substr(2), value, plain(option.help));
    }
  }
  return text;
}

}  // namespace

std::string completion_script(const CLI::App& app, std::string_view shell) {
  if (shell == "bash") return bash(app);
  if (shell == "zsh") return zsh(app);
  if (shell == "fish") return fish(app);
  throw usage_error(fmt::format("completion: found '{}', expected bash, zsh or fish", excerpt(shell)));
}

}  // namespace proofmass::cli
