// SPDX-License-Identifier: Apache-2.0
// The verbs that print what is made from all verbs and their options.
#include <memory>
#include <string>

#include "completion/completion.hpp"
#include "manual.hpp"
#include "output.hpp"
#include "verbs/verbs.hpp"

namespace proofmass::cli {

Action add_completion(CLI::App& verb) {
  auto shell = std::make_shared<std::string>();
  verb.add_option("SHELL", *shell, "The shell: bash, zsh or fish")->required()->type_name("bash|zsh|fish");
  verb.footer(
      "Examples:\n"
      "  proofmass completion bash > ~/.local/share/bash-completion/completions/proofmass\n"
      "  source <(proofmass completion bash)\n");
  return [shell, &verb] { print(completion_script(*verb.get_parent(), *shell)); };
}

Action add_manual(CLI::App& verb) {
  auto name = std::make_shared<std::string>();
  verb.add_option("VERB", *name, "A verb; without one, the page of the program")->type_name("VERB");
  verb.footer(
      "Examples:\n"
      "  proofmass manual identify > proofmass-identify.1\n"
      "  proofmass manual | man -l -\n");
  return [name, &verb] { print(manual_page(*verb.get_parent(), *name)); };
}

Action add_help(CLI::App& verb) {
  auto name = std::make_shared<std::string>();
  verb.add_option("VERB", *name, "A verb; without one, the help of the program")->type_name("VERB");
  verb.footer(
      "Examples:\n"
      "  proofmass help\n"
      "  proofmass help identify\n");
  // "help VERB" has become "VERB --help" before it is parsed.
  return [name] {};
}

}  // namespace proofmass::cli
