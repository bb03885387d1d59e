// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "complaint.hpp"
#include "help_text.hpp"
#include "interrupts.hpp"
#include "output.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/core/nearest.hpp"
#include "proofmass/core/version.hpp"
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
    throw usage_error(
        message("unknown verb '{}', expected one of {}{}", excerpt(word), list, did_you_mean(word, names)));
  }
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
int dispatch(const std::vector<std::string>& typed) {
  CLI::App app("Identifies the static model of quartz flexure accelerometers from test-stand records.",
               "proofmass");
  app.set_version_flag("--version", fmt::format("proofmass {}", version()));
  app.require_subcommand(1);
  app.footer(kFooter);
  app.formatter(std::make_shared<HelpText>());  // of the verbs too
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

// What the words ask for; errors go to standard error, in the language of the words.
int answer(const std::vector<std::string>& typed) {
  const Language language = language_of(typed);
  leave_when_interrupted(complaint(interruption(), language));
  try {
    return dispatch(typed);
  } catch (const Error& error) {
    complain(complaint(error, language));
    return exit_code(error.kind());
  } catch (const std::bad_alloc&) {
    complain(complaint(Error(ErrorKind::internal, "out of memory"), language));
  } catch (const std::exception& error) {
    complain(complaint(Error(ErrorKind::internal, message("internal error: {}", error.what())), language));
  }
  return exit_code(ErrorKind::internal);
}

}  // namespace
}  // namespace proofmass::cli

int main(int argc, char** argv) {
  // A closed pipe then fails the write instead of ending the process without a word.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // likewise a file that grows past its limit
  try {
    return proofmass::cli::answer(proofmass::cli::as_typed(argc, argv));
  } catch (const std::exception&) {
    return proofmass::exit_code(proofmass::ErrorKind::internal);  // without the memory to say so
  }
}
