// SPDX-License-Identifier: Apache-2.0
// What is made from the verbs and their options for shells and man.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "support/command_line.hpp"

namespace proofmass::test {
namespace {

using Completion = CommandLine;

// What bash offers after these words.
std::string completed(const std::string& script, const std::string& words) {
  const Launch shell{
      .command = {"/bin/bash", "-c",
                  "source \"$1\"; COMP_WORDS=($2 \"$3\"); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); "
                  "_proofmass; echo ${COMPREPLY[*]}",
                  "bash", script, words.substr(0, words.rfind(' ')), words.substr(words.rfind(' ') + 1)}};
  const Outcome outcome = run_process(shell);
  return outcome.out + outcome.err + (outcome.exit_code == 0 ? "" : std::to_string(outcome.exit_code));
}

TEST_F(Completion, OffersVerbsOptionsAndChoicesInBash) {
  const std::string script = write("completion.bash", proofmass({"completion", "bash"}).out);
  EXPECT_EQ(completed(script, "proofmass ident"), "identify\n");
  EXPECT_EQ(completed(script, "proofmass identify --split-"), "--split-by\n");
  EXPECT_EQ(completed(script, "proofmass identify --split-by m"), "mount\n");
  EXPECT_EQ(completed(script, "proofmass compare --method"), "--methods\n");
  EXPECT_EQ(completed(script, "proofmass identify --method pso"), "pso-bp\n");
  EXPECT_EQ(completed(script, "proofmass help ins"), "inspect\n");
}

TEST_F(Completion, KnowsEveryOptionInEveryShell) {
  std::istringstream help(proofmass({"help", "identify"}).out);
  for (const char* const shell : {"bash", "zsh", "fish"}) {
    const Outcome script = proofmass({"completion", shell});
    EXPECT_EQ(script.exit_code, 0);
    help.clear();
    help.seekg(0);
    std::size_t options = 0;
    for (std::string line; std::getline(help, line);) {
      if (!line.starts_with("  --")) continue;
      const std::string name = line.substr(4, line.find(' ', 4) - 4);
      EXPECT_NE(script.out.find(name), std::string::npos) << shell << ": " << name;
      ++options;
    }
    EXPECT_GT(options, 50U);
  }
  expect_failure(proofmass({"completion", "tcsh"}), 2, {"bash, zsh or fish"});
}

TEST_F(Completion, ComesWithManualPages) {
  const Outcome page = proofmass({"manual", "identify"});
  EXPECT_EQ(page.exit_code, 0);
  for (const char* const part :
       {".TH PROOFMASS-IDENTIFY 1", ".B \\-\\-split\\-by row|mount", ".SH OPTIONS OF WLS", ".SH EXAMPLES"}) {
    EXPECT_NE(page.out.find(part), std::string::npos) << part;
  }
  EXPECT_NE(proofmass({"manual"}).out.find(".BR proofmass\\-identify (1)"), std::string::npos);
  expect_failure(proofmass({"manual", "nosuch"}), 2, {"unknown verb 'nosuch'"});
}

// No line of any help is longer than 80 columns.
TEST_F(Completion, HelpKeepsTo80Columns) {
  for (const char* const verb : {"simulate", "identify", "compare", "reproduce", "predict", "inspect"}) {
    std::istringstream help(proofmass({"help", verb}).out);
    for (std::string line; std::getline(help, line);) EXPECT_LE(line.size(), 82U) << verb << ": " << line;
  }
}

}  // namespace
}  // namespace proofmass::test
