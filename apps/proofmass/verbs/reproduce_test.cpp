// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <csignal>
#include <thread>

#include "support/command_line.hpp"

namespace proofmass::test {
namespace {

using ReproduceVerb = CommandLine;

TEST_F(ReproduceVerb, RefusesWhatMakesNoSense) {
  expect_failure(proofmass({"reproduce", "--seed", "x"}), 2, {"--seed"});
  expect_failure(proofmass({"reproduce", "twin.toml"}), 2, {"twin.toml"});
  const std::string file = write("taken", "text");
  expect_failure(proofmass({"reproduce", "--out", file}), 2, {"--out", "taken", "not a folder"});
  expect_failure(proofmass({"reproduce", "--out", file + "/sub/folder"}), 2, {"taken/sub/folder"});
  expect_failure(proofmass({"reproduce", "--out", "/proc/nowhere"}), 2, {"/proc/nowhere"});
  expect_failure(proofmass({"reproduce", "--out", "/proc"}), 2, {"/proc"});
  EXPECT_EQ(names(), std::vector<std::string>{"taken"});
}

TEST_F(ReproduceVerb, CitesThePaperInItsHelp) {
  const std::string help = proofmass({"reproduce", "--help"}).out;
  for (const char* part :
       {"The paper: 史有志", "《基于PSO-BP的石英挠性加速度计静态模型辨识》", "45(3), 2025"}) {
    EXPECT_NE(help.find(part), std::string::npos) << part << " in\n" << help;
  }
}

TEST_F(ReproduceVerb, StopsWhenInterruptedAndWritesNothing) {
  Process process(launch({"reproduce", "--out", at("results")}));
  while (process.is_running() && process.errors_so_far().empty()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_NE(process.errors_so_far().find("Table "), std::string::npos) << process.errors_so_far();
  process.send(SIGINT);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace proofmass::test
