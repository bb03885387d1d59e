// SPDX-License-Identifier: Apache-2.0
// What is made from the verbs and their options for shells and man.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "proofmass/report/terminal/wrapped_text.hpp"
#include "proofmass/report/text/display_width.hpp"
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

// As the help of the program lists them.
std::vector<std::string> verbs() {
  const Outcome shown = run_process({.command = {PROOFMASS_CLI, "help"}});
  std::istringstream help(shown.out.substr(shown.out.find("Subcommands:")));
  std::vector<std::string> names;
  std::string line;
  std::getline(help, line);
  while (std::getline(help, line) && line.starts_with("  ")) {
    if (line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

TEST_F(Completion, KnowsEveryVerbEverywhere) {
  EXPECT_EQ(verbs().size(), 10U);
  const std::string bash = proofmass({"completion", "bash"}).out;
  const std::string zsh = proofmass({"completion", "zsh"}).out;
  const std::string fish = proofmass({"completion", "fish"}).out;
  const std::string manual = proofmass({"manual"}).out;
  std::string list;
  for (const std::string& verb : verbs()) {
    list += verb + " ";
    EXPECT_NE(zsh.find("\n    '" + verb + ":"), std::string::npos) << verb;
    EXPECT_NE(fish.find(" -f -a " + verb + " -d "), std::string::npos) << verb;
    EXPECT_NE(manual.find(".BR proofmass\\-" + verb + " (1)"), std::string::npos) << verb;
    EXPECT_EQ(read_file(std::string(PROOFMASS_PAGES "/proofmass-") + verb + ".1"),
              proofmass({"manual", verb}).out)
        << "what an installation brings along";
  }
  EXPECT_NE(bash.find("'" + list + "--help"), std::string::npos) << list;
}

TEST_F(Completion, OffersVerbsOptionsAndChoicesInBash) {
  const std::string script = write("completion.bash", proofmass({"completion", "bash"}).out);
  EXPECT_EQ(completed(script, "proofmass ident"), "identify\n");
  EXPECT_EQ(completed(script, "proofmass identify --split-"), "--split-by\n");
  EXPECT_EQ(completed(script, "proofmass identify --split-by m"), "mount\n");
  EXPECT_EQ(completed(script, "proofmass compare --method"), "--methods\n");
  EXPECT_EQ(completed(script, "proofmass identify --method pso"), "pso-bp\n");
  EXPECT_EQ(completed(script, "proofmass help ins"), "inspect\n");
  EXPECT_EQ(completed(script, "proofmass completion "), "bash zsh fish\n");
  for (const std::string verb : {"help", "manual"})
    EXPECT_EQ(completed(script, "proofmass " + verb + " "),
              "simulate identify compare reproduce predict inspect report completion manual help\n");
}

// bash hands --method=pso over as three words, or as one where = has been taken off COMP_WORDBREAKS.
TEST_F(Completion, OffersChoicesAfterAnEqualsSignInBash) {
  const std::string script = write("completion.bash", proofmass({"completion", "bash"}).out);
  EXPECT_EQ(completed(script, "proofmass identify --method = pso"), "pso-bp\n");
  EXPECT_EQ(completed(script, "proofmass identify --split-by ="), "row mount\n");
  EXPECT_EQ(completed(script, "proofmass identify --method=pso"), "--method=pso-bp\n");
  EXPECT_EQ(completed(script, "proofmass compare --methods=ols,t"), "--methods=ols,tls\n");
}

TEST_F(Completion, OffersTheLastElementOfAListInBash) {
  const std::string script = write("completion.bash", proofmass({"completion", "bash"}).out);
  EXPECT_EQ(completed(script, "proofmass compare --methods pso"), "pso-bp\n");
  EXPECT_EQ(completed(script, "proofmass compare --methods ols,tls,pso"), "ols,tls,pso-bp\n");
  EXPECT_EQ(completed(script, "proofmass compare --methods = ols,t"), "ols,tls\n");
  EXPECT_EQ(completed(script, "proofmass compare --methods ols,o"), "\n") << "ols is there already";
  EXPECT_EQ(completed(script, "proofmass identify --terms K0,Kio"), "K0,Kio K0,Kioo K0,Kiop\n");
}

TEST_F(Completion, OffersFilesWhereOneIsTakenInBash) {
  const std::string script = write("completion.bash", proofmass({"completion", "bash"}).out);
  EXPECT_EQ(completed(script, "proofmass identify " + script), script + "\n");
  EXPECT_EQ(completed(script, "proofmass identify --json " + script), script + "\n");
  EXPECT_EQ(completed(script, "proofmass identify --out " + script), "\n") << "a folder is taken";
  EXPECT_EQ(completed(script, "proofmass identify --split " + script), "\n") << "a number is taken";
}

// The figures of the options are the same in every shell; zsh and fish say besides what each is for.
TEST_F(Completion, SaysWhatIsTakenInZshAndFish) {
  const std::string zsh = proofmass({"completion", "zsh"}).out;
  for (
      const char* const part :
      {R"('--rows=[Rows, in place of the plan'\''s]:N: ')", R"(:FILE:_files')", R"(:DIR:_files -/')",
       R"('--methods=[Methods to compare, separated by commas; ratios refer to the first]:value:_values -s , )",
       R"(':STAND.toml:_files')", R"(':value:(bash zsh fish)')"}) {
    EXPECT_NE(zsh.find(part), std::string::npos) << part;
  }
  const std::string fish = proofmass({"completion", "fish"}).out;
  for (const char* const part :
       {R"(-l rows -x -d 'Rows, in place of the plan\'s')", "-l json -r -F -d", "-l out -x -a '(",
        R"(Ai=#3; E=out[mA] also says)", "completion' -f -a 'bash zsh fish'"}) {
    EXPECT_NE(fish.find(part), std::string::npos) << part;
  }
  EXPECT_NE(zsh.find(R"(E=out\[mA\] also says)"), std::string::npos);
}

// In the shell itself, where the machine has one.
TEST_F(Completion, WorksInFish) {
  if (!std::filesystem::exists("/usr/bin/fish")) GTEST_SKIP() << "no fish here";
  const std::string script = write("completion.fish", proofmass({"completion", "fish"}).out);
  const auto offered = [&](const std::string& words) {
    const Outcome outcome =
        run_process({.command = {"/usr/bin/fish", "--no-config", "-c",
                                 "source $argv[1]; complete -C $argv[2]", script, words}});
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  };
  EXPECT_EQ(offered("proofmass completion "), "bash\nfish\nzsh\n");
  EXPECT_EQ(offered("proofmass identify --method pso"), "pso-bp\tHow to identify (default ols)\n");
  EXPECT_TRUE(offered("proofmass compare --methods ols,pso").starts_with("ols,pso-bp\t"));
  EXPECT_EQ(offered("proofmass reproduce "), "");
  EXPECT_EQ(offered("proofmass identify --split "), "");
  EXPECT_EQ(offered("proofmass simulate --row"), "--rows\tRows, in place of the plan's\n");
}

TEST_F(Completion, IsValidZsh) {
  if (!std::filesystem::exists("/usr/bin/zsh")) GTEST_SKIP() << "no zsh here";
  const std::string script = write("completion.zsh", proofmass({"completion", "zsh"}).out);
  const Outcome outcome = run_process({.command = {"/usr/bin/zsh", "--no-rcs", "-n", script}});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
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
  expect_failure(proofmass({"manual", "identfy"}), 2, {"did you mean identify?"});
}

// No line of any help is longer than 80 columns.
TEST_F(Completion, HelpKeepsTo80Columns) {
  for (const std::string& verb : verbs()) {
    std::istringstream help(proofmass({"help", verb}).out);
    for (std::string line; std::getline(help, line);)
      EXPECT_LE(display_width(line), 82U) << verb << ": " << line;
  }
}

}  // namespace
}  // namespace proofmass::test
