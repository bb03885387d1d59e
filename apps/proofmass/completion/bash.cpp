// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "completion/completion.hpp"
#include "completion/options_shown.hpp"

namespace proofmass::cli {
namespace {

// bash parts words at =, unless it is told not to: both are understood.
constexpr std::string_view kWords = R"(
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local prefix= takes= words= listed= word
  COMPREPLY=()
  if [[ $current == --*=* ]]; then
    previous=${current%%=*} prefix=${current%%=*}= current=${current#*=}
  elif [[ $current == = ]]; then
    current=
  elif [[ $previous == = ]]; then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi
)";

// Of a list the last element is completed, by what is not in it yet, and a comma may follow.
constexpr std::string_view kReplies = R"(
  case $takes in
    list)
      [[ $current != *,* ]] || listed=${current%,*}, current=${current##*,}
      for word in $words; do
        [[ ,$listed == *,$word,* ]] || COMPREPLY+=("$prefix$listed$word")
      done
      mapfile -t COMPREPLY < <(compgen -W "${COMPREPLY[*]}" -- "$prefix$listed$current")
      compopt -o nospace 2>/dev/null
      ;;
    words) mapfile -t COMPREPLY < <(compgen -P "$prefix" -W "$words" -- "$current") ;;
    files) mapfile -t COMPREPLY < <(compgen -P "$prefix" -f -- "$current") ;;
    folders) mapfile -t COMPREPLY < <(compgen -P "$prefix" -d -- "$current") ;;
  esac
  [[ $takes != f* ]] || compopt -o filenames 2>/dev/null
}
complete -F _proofmass proofmass
)";

std::string assignment(const ShownOption& option) {
  switch (option.takes) {
    case Takes::one_of:
      return fmt::format("takes=words words='{}'", fmt::join(option.choices, " "));
    case Takes::list_of:
      return fmt::format("takes=list words='{}'", fmt::join(option.choices, " "));
    case Takes::file:
      return "takes=files";
    case Takes::folder:
      return "takes=folders";
    case Takes::text:
    case Takes::nothing:
      break;
  }
  return "takes=text";
}

// The branches of a case, those that come to the same as one.
class Branches {
 public:
  void add(const std::string& pattern, const std::string& result) {
    std::string& patterns = patterns_[result];
    patterns.append(patterns.empty() ? "" : " | ").append(pattern);
  }
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const auto& [result, patterns] : patterns_)
      text += fmt::format("      {})\n        {} ;;\n", patterns, result);
    return text;
  }

 private:
  std::map<std::string, std::string> patterns_;
};

}  // namespace

std::string bash_completion(const CLI::App& app) {
  Branches values;
  Branches options;
  Branches arguments;
  for (const CLI::App* const verb : app.get_subcommands({})) {
    std::string names;
    for (const ShownOption& option : options_shown(*verb)) {
      names.append(names.empty() ? "" : " ").append(option.name);
      if (option.takes != Takes::nothing)
        values.add(verb->get_name() + ":" + option.name, assignment(option));
    }
    options.add(verb->get_name(), fmt::format("takes=words words='{}'", names));
    // Further arguments are files as the first is.
    const std::vector<ShownOption> taken = arguments_shown(*verb);
    if (!taken.empty()) arguments.add(verb->get_name(), assignment(taken.front()));
  }
  std::string text = "# bash completion of proofmass\n_proofmass() {";
  text += kWords;
  text += fmt::format("  if ((COMP_CWORD == 1)); then\n    takes=words words='{} --help --version'\n  else\n",
                      fmt::join(verb_names(app), " "));
  text += "    case ${COMP_WORDS[1]}:$previous in\n" + values.text() + "    esac\n  fi\n";
  text += "  if [[ -z $takes && $current == -* ]]; then\n    case ${COMP_WORDS[1]} in\n" + options.text() +
          "    esac\n  fi\n";
  text +=
      "  if [[ -z $takes ]]; then\n    case ${COMP_WORDS[1]} in\n" + arguments.text() + "    esac\n  fi\n";
  text += std::string(kReplies.substr(1));
  return text;
}

}  // namespace proofmass::cli
