// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "help_text.hpp"
#include "interrupts.hpp"
#include "output.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/core/nearest.hpp"
#include "proofmass/core/version.hpp"
#include "proofmass/report/text/en.hpp"
#include "proofmass/report/text/endings.hpp"
#include "verbs/verbs.hpp"

namespace proofmass::cli {
namespace {

struct Verb {
  const char* name;
  const char* description;
  Action (*add)(CLI::App&);
};

constexpr std::array kVerbs{
    Verb{"simulate", "Simulate a test record of a known model, with the errors of a test stand",
         add_simulate},
    Verb{"identify", "Identify the static model of an accelerometer from a test record", add_identify},
    Verb{"compare", "Identify by several methods on the same rows and put them side by side", add_compare},
    Verb{"reproduce", "Repeat the paper's experiment on a simulated twin", add_reproduce},
    Verb{"predict", "Predict the output for given accelerations from a result file", add_predict},
    Verb{"inspect", "Summarise a test record and the terms that its inputs can identify", add_inspect},
    Verb{"report", "Write the report of a result as one HTML page with figures", add_report},
    Verb{"completion", "Print what completes commands in a shell", add_completion},
    Verb{"manual", "Print the manual page of the program or of a verb, for man", add_manual},
    Verb{"help", "Show the help of the program or of a verb", add_help},
};

constexpr auto kFooter =
    "Exit codes: 0 done, 1 internal error, 2 usage, 3 bad input data, 4 refused,\n130 interrupted.\n"
    "\"proofmass VERB --help\" lists a verb's options and shows examples.";

// Standard error may be closed or full; the exit code then has to say it all.
void complain(const std::string& message) noexcept {
  std::fputs("proofmass: error: ", stderr);
  std::fputs(message.c_str(), stderr);
  std::fputs("\n", stderr);
}

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

// Why, and what a user can do about it, as flags: "--split 1 or --terms K0,Ki,...".
std::string explained(const Error& error) {
  std::string text = error.what();
  for (const Finding& finding : error.findings()) text += "\n  " + english(finding);
  if (!error.ending().empty()) text += "\n  ended: " + sentence(error.ending(), Language::en);
  std::string flags;
  for (const Remedy& remedy : error.remedies()) {
    const std::string value = !remedy.value.empty()      ? remedy.value
                              : remedy.option == "terms" ? "K0,Ki,..."
                                                         : "X";
    flags += fmt::format("{}--{} {}",
                         flags.empty()          ? ""
                         : remedy.with_previous ? " "
                                                : " or ",
                         remedy.option, for_the_shell(value));
  }
  return flags.empty() ? text : fmt::format("{}\ntry: {}", text, flags);
}

// A word that should have been a verb; CLI11 would only say that a verb is missing.
void require_known_verb(const std::string& word) {
  std::vector<std::string_view> names;
  std::string list;
  for (const Verb& verb : kVerbs) {
    if (word == verb.name) return;
    names.emplace_back(verb.name);
    list.append(list.empty() ? "" : ", ").append(verb.name);
  }
  if (!word.starts_with('-')) {
    throw usage_error(fmt::format("unknown verb '{}', expected one of {}{}", excerpt(word), list,
                                  did_you_mean(word, names)));
  }
}

// What CLI11 says of a word that the verb does not know, with the option that it looks like and the page of
// help that lists them.
Error misused(const CLI::ParseError& error, const CLI::App& app, std::span<const std::string> words) {
  std::string page = "proofmass --help";
  std::string meant;
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
  return usage_error(fmt::format("{}{} (see {})", error.what(), meant, page));
}

// "proofmass" and "proofmass help" are the program's help, "proofmass help VERB" is the verb's.
std::vector<std::string> as_typed(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (words.empty()) return {"--help"};
  if (words.front() != "help" || (words.size() > 1 && words[1] == "--help")) return words;
  words.erase(words.begin());
  words.emplace_back("--help");
  return words;
}

// Adds the verbs, and returns what each of them does. The options of a verb that no word names would be made
// for nothing; completion and manual pages are made from those of all.
std::vector<std::pair<CLI::App*, Action>> add_verbs(CLI::App& app, std::span<const std::string> words) {
  const bool all = words.front() == "completion" || words.front() == "manual";
  std::vector<std::pair<CLI::App*, Action>> actions;
  for (const Verb& verb : kVerbs) {
    CLI::App* const added = app.add_subcommand(verb.name, verb.description);
    if (all || std::find(words.begin(), words.end(), verb.name) != words.end())
      actions.emplace_back(added, verb.add(*added));
  }
  return actions;
}

// Parses the command line and does what it says. CLI11 would exit with codes of its own (105 and up): they
// become the contract's 2.
int dispatch(int argc, char** argv) {
  CLI::App app("Identifies the static model of quartz flexure accelerometers from test-stand records.",
               "proofmass");
  app.set_version_flag("--version", fmt::format("proofmass {}", version()));
  app.require_subcommand(1);
  app.footer(kFooter);
  app.formatter(std::make_shared<HelpText>());  // of the verbs too
  const std::vector<std::string> typed = as_typed(argc, argv);
  const auto actions = add_verbs(app, typed);
  require_known_verb(typed.front());
  try {
    app.parse(std::vector<std::string>(typed.rbegin(), typed.rend()));  // CLI11 takes them from the back
  } catch (const CLI::CallForVersion& version_text) {
    print(fmt::format("{}\n", version_text.what()));
    return 0;
  } catch (const CLI::Success&) {
    print(app.help());
    return 0;
  } catch (const CLI::ParseError& error) {
    throw misused(error, app, typed);
  }
  for (const auto& [verb, action] : actions) {
    if (verb->parsed()) action();
  }
  return 0;
}

}  // namespace
}  // namespace proofmass::cli

int main(int argc, char** argv) {
  // A closed pipe then fails the write instead of ending the process without a word.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // likewise a file that grows past its limit
  proofmass::cli::leave_when_interrupted();
  try {
    return proofmass::cli::dispatch(argc, argv);
  } catch (const proofmass::Error& error) {
    proofmass::cli::complain(proofmass::cli::explained(error));
    return proofmass::exit_code(error.kind());
  } catch (const std::bad_alloc&) {
    proofmass::cli::complain("out of memory");
  } catch (const std::exception& error) {
    proofmass::cli::complain(fmt::format("internal error: {}", error.what()));
  }
  return proofmass::exit_code(proofmass::ErrorKind::internal);
}
