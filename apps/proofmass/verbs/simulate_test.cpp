// SPDX-License-Identifier: Apache-2.0
#include "support/command_line.hpp"

namespace proofmass::test {
namespace {

using SimulateVerb = CommandLine;

std::string twin() { return PROOFMASS_SOURCE_DIR "/data/twin.toml"; }

TEST_F(SimulateVerb, WritesTheSameBytesForTheSameSeed) {
  const Outcome first = proofmass({"simulate", twin(), "--rows", "50", "--seed", "7"});
  const Outcome file = proofmass({"simulate", twin(), "--rows", "50", "--seed", "7", "--out", at("run.csv")});
  const Outcome other = proofmass({"simulate", twin(), "--rows", "50", "--seed", "8"});
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(file.out, "");
  EXPECT_EQ(first.out, read("run.csv"));
  EXPECT_NE(first.out, other.out);
  EXPECT_NE(first.out.find("Ai[g],Ao[g],Ap[g],E[g]"), std::string::npos);
}

TEST_F(SimulateVerb, TakesRowsAndNoiseFromTheCommandLine) {
  make_record("40", "0");
  const Outcome fit = proofmass({"identify", at("run.csv"), "--split", "1", "--json", at("r.json")});
  ASSERT_EQ(fit.exit_code, 0) << fit.err;
  const Json result = read_json("r.json");
  EXPECT_EQ(result["metrics"]["train"]["n"], 40);
  EXPECT_NEAR(result["coefficients"][1]["value"].get<double>(), 0.999979, 1e-13);
}

TEST_F(SimulateVerb, RefusesBadPlansAndPlacesAndWritesNothing) {
  const std::string bad = write("bad.toml", "rows = 10\n[model]\nKx = 1\n");
  expect_failure(proofmass({"simulate", bad, "--out", at("run.csv")}), 3, {"bad.toml", "Kx"});
  expect_failure(proofmass({"simulate", at("none.toml")}), 3, {"none.toml"});
  expect_failure(proofmass({"simulate", twin(), "--rows", "0"}), 2, {"--rows", "'0'", "from 1 to"});
  expect_failure(proofmass({"simulate", twin(), "--sigma-ug", "-1"}), 2, {"--sigma-ug", "'-1'", "from 0 to"});
  expect_failure(proofmass({"simulate", twin(), "--out", at("no/run.csv")}), 2, {"no/run.csv", "no folder"});
  EXPECT_EQ(names(), std::vector<std::string>{"bad.toml"});
}

TEST_F(SimulateVerb, FailsOnAFullDisk) {
  Launch program = launch({"simulate", twin(), "--rows", "5"});
  program.standard_output = "/dev/full";
  const Outcome outcome = run_process(program);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("standard output: No space left"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace proofmass::test
