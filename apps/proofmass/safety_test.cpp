// SPDX-License-Identifier: Apache-2.0
// What must never happen: files left behind by a failure, inputs destroyed, numbers that are none.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "support/command_line.hpp"

namespace proofmass {
namespace {

using test::expect_failure;
using test::Outcome;

class Safety : public test::CommandLine {
 protected:
  // Runs a line of the shell in which $P is the program.
  [[nodiscard]] static Outcome shell(const std::string& line) {
    return test::run_process({.command = {"/bin/sh", "-c", std::string("P=") + PROOFMASS_CLI + "; " + line}});
  }
};

TEST_F(Safety, AFullStandardOutputLeavesNoFiles) {
  const std::string record = make_record();
  const Outcome full =
      shell("$P identify " + record + " --json " + at("r.json") + " --out " + at("results") + " >/dev/full");
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_EQ(names(), std::vector<std::string>{"run.csv"});
}

TEST_F(Safety, AFailureTakesTheFoldersItMadeWithIt) {
  const std::string record = make_record();
  const auto ask = [&](const std::string& out) {
    return proofmass({"identify", record, "--out", at(out), "--json", "/dev/full"});
  };
  expect_failure(ask("a/b/c"), 2, {"/dev/full"});
  EXPECT_EQ(names(), std::vector<std::string>{"run.csv"});
  std::filesystem::create_directory(at("mine"));
  expect_failure(ask("mine"), 2, {"/dev/full"});
  expect_failure(ask("mine/../b/c/"), 2, {"/dev/full"});
  EXPECT_TRUE(std::filesystem::is_empty(at("mine")));
  EXPECT_FALSE(exists("b"));
  expect_failure(ask("run.csv/results"), 2, {"run.csv/results", "cannot make the folder"});
}

TEST_F(Safety, PlacesThatCannotBeWrittenAreFoundBeforeTheComputation) {
  // Methods that would run for days.
  const std::string record = make_record();
  const std::vector<std::string> endless{"--particles", "100000", "--iterations", "10000000"};
  const auto fails = [&](std::vector<std::string> command, const std::string& place) {
    command.insert(command.end(), endless.begin(), endless.end());
    expect_failure(proofmass(std::move(command)), 2, {place});
  };
  fails({"identify", record, "--method", "pso-bp", "--json", "/proc/x.json"}, "/proc/x.json");
  fails({"identify", record, "--method", "pso-bp", "--out", record + "/results"}, "run.csv/results");
  fails({"compare", record, "--methods", "pso-bp", "--json", "/proc/x.json"}, "/proc/x.json");
  fails({"compare", record, "--methods", "pso-bp", "--json", at("")}, "annot write");
  fails({"identify", record, "--method", "pso-bp", "--json", at("new"), "--out", "/proc/nowhere"},
        "/proc/nowhere");
  EXPECT_EQ(names(), std::vector<std::string>{"run.csv"});
}

TEST_F(Safety, TheExitCodeSurvivesAClosedStandardError) {
  EXPECT_EQ(shell("$P identify " + at("none.csv") + " 2>&-").exit_code, 3);
  EXPECT_EQ(shell("$P identify " + at("none.csv") + " 2>/dev/full").exit_code, 3);
  EXPECT_EQ(shell("$P --bogus 2>/dev/full").exit_code, 2);
}

TEST_F(Safety, InputsAreNotOverwritten) {
  const std::string record = make_record();
  const std::string before = read("run.csv");
  expect_failure(proofmass({"identify", record, "--json", record}), 2, {"run.csv", "is an input"});
  expect_failure(proofmass({"inspect", record, "--json", record}), 2, {"run.csv", "is an input"});
  EXPECT_EQ(read("run.csv"), before);
}

TEST_F(Safety, OverflowIsRefused) {
  std::string record = "Ai,E\n";
  for (int k = 0; k < 20; ++k) record += std::to_string(k) + "," + std::to_string(k % 3) + "e308\n";
  expect_failure(
      proofmass({"identify", write("huge.csv", record), "--terms", "K0,Ki", "--json", at("h.json")}), 3,
      {"huge.csv", "column 'E'"});
  EXPECT_FALSE(exists("h.json"));
}

// Whether the row trains or tests.
TEST_F(Safety, ValuesBeyondTheRangeOfNumbersAreRefusedByTheirLine) {
  const std::pair<const char*, const char*> beyond[] = {{"E", "17,1e+300"}, {"Ai", "-1e+150,34"}};
  for (const auto& [column, row] : beyond) {
    std::string text = "Ai,E\n";
    for (int k = 0; k < 40; ++k) {
      text +=
          k == 17 ? std::string(row) + "\n" : std::to_string(k) + "," + std::to_string(2 * k + k % 3) + "\n";
    }
    const std::string file = write("beyond.csv", text);
    for (const char* const seed : {"1", "2", "3", "4", "5", "6"}) {
      expect_failure(proofmass({"identify", file, "--terms", "K0,Ki", "--seed", seed}), 3,
                     {"beyond.csv:19", column, "measured value"});
    }
    expect_failure(proofmass({"inspect", file}), 3, {"beyond.csv:19", column});
  }
}

TEST_F(Safety, UncertaintiesBeyondTheRangeOfNumbersAreRefused) {
  const std::string record = make_record("100");
  for (const char* const method : {"tls", "eiv"}) {
    const auto fails = [&](const char* output, const char* input, const std::string& option) {
      expect_failure(proofmass({"identify", record, "--method", method, "--sigma-output-ug", output,
                                "--sigma-input-ug", input, "--json", at("r.json")}),
                     2, {option});
    };
    fails("300", "1e-300", "the uncertainty of the inputs");
    fails("1e-200", "300", "the uncertainty of the output");
    fails("1e-300", "1e-300", "the uncertainty of");
  }
  // Every row but one as it should be.
  const auto with_sigma = [this](const std::string& sigma) {
    std::string text = "Ai,E,sigma_E,sigma_Ai\n";
    for (int k = 0; k < 40; ++k) {
      text +=
          std::to_string(k) + "," + std::to_string(2 * k + k % 3) + "," + (k == 17 ? sigma : "1") + ",0.1\n";
    }
    return write("sigma.csv", text);
  };
  for (const char* const sigma : {"0", "1e-300", "1e+300"}) {
    const std::string uncertain = with_sigma(sigma);
    for (const char* const method : {"wls", "tls", "eiv"}) {
      // Whether the row trains or tests.
      for (const char* const seed : {"1", "2", "3", "4", "5", "6"}) {
        expect_failure(
            proofmass({"identify", uncertain, "--method", method, "--terms", "K0,Ki", "--seed", seed}), 3,
            {"sigma.csv:19", "sigma_E", sigma});
      }
    }
    EXPECT_EQ(proofmass({"identify", uncertain, "--method", "ols", "--terms", "K0,Ki"}).exit_code, 0);
  }
  for (const char* const sigma : {"1e-30", "1e30"}) {
    const std::string uncertain = with_sigma(sigma);
    for (const char* const method : {"wls", "tls", "eiv"}) {
      const Outcome outcome =
          proofmass({"identify", uncertain, "--method", method, "--terms", "K0,Ki", "--split", "1"});
      EXPECT_NE(outcome.exit_code, 1) << method << ": " << outcome.err;
    }
  }
  EXPECT_FALSE(exists("r.json"));
}

TEST_F(Safety, EndlessPlansAndResultsEnd) {
  expect_failure(proofmass({"simulate", "/dev/zero"}), 3, {"/dev/zero", "more than 16 MiB"});
}

TEST_F(Safety, EarlyStoppingLeavesLeastSquaresAlone) {
  const std::string record = make_record();
  ASSERT_EQ(proofmass({"identify", record, "--split", "0.7", "--json", at("a.json")}).exit_code, 0);
  ASSERT_EQ(proofmass({"compare", record, "--methods", "ols,bp", "--early-stopping", "on", "--epochs", "5",
                       "--json", at("b.json")})
                .exit_code,
            0);
  EXPECT_EQ(read_json("a.json")["coefficients"],
            read_json("b.json")["methods"][0]["runs"][0]["coefficients"]);
}

TEST_F(Safety, ANetworkWithoutItsNetworkDoesNotPredict) {
  const std::string record = make_record();
  ASSERT_EQ(
      proofmass({"identify", record, "--method", "bp", "--epochs", "5", "--json", at("r.json")}).exit_code,
      0);
  Json result = read_json("r.json");
  result.erase("network");
  expect_failure(proofmass({"predict", write("bare.json", result.dump()), record}), 3,
                 {"without its network"});
}

}  // namespace
}  // namespace proofmass
