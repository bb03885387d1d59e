// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "interrupts.hpp"
#include "output.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/core/version.hpp"
#include "proofmass/report/text/en.hpp"
#include "verbs/verbs.hpp"

namespace proofmass::cli {
namespace {

struct Verb {
  const char* name;
  const char* description;
  Action (*add)(CLI::App&);
};

constexpr std::array kVerbs{
    Verb{"simulate", "Make a test record from a known model and a stand's faults", add_simulate},
    Verb{"identify", "Identify the static model of an accelerometer from a test record", add_identify},
    Verb{"compare", "Identify by several methods on the same rows and put them side by side", add_compare},
    Verb{"reproduce", "Repeat the paper's experiment on a simulated twin", add_reproduce},
    Verb{"predict", "Predict the output for given accelerations from a result file", add_predict},
    Verb{"inspect", "Summarise a test record and the terms that its inputs can identify", add_inspect},
};

constexpr auto kFooter =
    "Exit codes: 0 done, 1 internal error, 2 usage, 3 bad input data, 4 refused, 130 interrupted.\n"
    "\"proofmass VERB --help\" lists a verb's options and shows examples.";

// Standard error may be closed or full; the exit code then has to say it all.
void complain(const std::string& message) noexcept {
  std::fputs("proofmass: error: ", stderr);
  std::fputs(message.c_str(), stderr);
  std::fputs("\n", stderr);
}

// Why, and what a user can do about it, as flags: "--split 1 or --terms K0,Ki,...".
std::string explained(const Error& error) {
  std::string text = error.what();
  for (const Finding& finding : error.findings()) text += "\n  " + english(finding);
  std::string flags;
  for (const Remedy& remedy : error.remedies()) {
    const std::string value = !remedy.value.empty()      ? remedy.value
                              : remedy.option == "terms" ? "K0,Ki,..."
                                                         : "X";
    flags += fmt::format("{}--{} {}",
                         flags.empty()          ? ""
                         : remedy.with_previous ? " "
                                                : " or ",
                         remedy.option, value);
  }
  return flags.empty() ? text : fmt::format("{}\ntry: {}", text, flags);
}

// A word that should have been a verb; CLI11 would only say that a verb is missing.
void require_known_verb(const std::string& word) {
  std::string list;
  for (const Verb& verb : kVerbs) {
    if (word == verb.name) return;
    list.append(list.empty() ? "" : ", ").append(verb.name);
  }
  if (!word.starts_with('-'))
    throw usage_error(fmt::format("unknown verb '{}', expected one of {}", word, list));
}

// Parses the command line and does what it says. CLI11 would exit with codes of its own (105 and up): they
// become the contract's 2.
int dispatch(int argc, char** argv) {
  CLI::App app("Identifies the static model of quartz flexure accelerometers from test-stand records.",
               "proofmass");
  app.set_version_flag("--version", fmt::format("proofmass {}", version()));
  app.require_subcommand(1);
  app.footer(kFooter);
  std::vector<std::pair<CLI::App*, Action>> actions;
  const std::vector<std::string_view> words(argv, argv + argc);
  for (const Verb& verb : kVerbs) {
    CLI::App* const added = app.add_subcommand(verb.name, verb.description);
    // The options of a verb that no word names would be made for nothing.
    if (std::find(words.begin(), words.end(), verb.name) == words.end()) continue;
    actions.emplace_back(added, verb.add(*added));
  }
  if (argc > 1) require_known_verb(argv[1]);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion& version_text) {
    print(fmt::format("{}\n", version_text.what()));
    return 0;
  } catch (const CLI::Success&) {
    print(app.help());
    return 0;
  } catch (const CLI::ParseError& error) {
    throw usage_error(fmt::format("{} (see proofmass --help)", error.what()));
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
