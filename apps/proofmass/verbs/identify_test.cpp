// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <thread>

#include "proofmass/identify/method.hpp"
#include "support/command_line.hpp"
#include "support/quick_flags.hpp"

namespace proofmass::test {
namespace {

using IdentifyVerb = CommandLine;

// Small enough to be quick with every method.
std::vector<std::string> operator+(std::vector<std::string> list, const std::vector<std::string>& more) {
  list.insert(list.end(), more.begin(), more.end());
  return list;
}

std::vector<std::string> quick(const std::string& record, std::string_view method) {
  return std::vector<std::string>{"identify",          record,           "--method",
                                  std::string(method), "--on-rank-loss", "drop"} +
         test::quick_flags(method);
}

TEST_F(IdentifyVerb, PrintsATableAndWritesTheFilesItNames) {
  const std::string record = make_record();
  const Outcome fit = proofmass({"identify", record, "--out", at("results"), "--json", at("r.json")});
  ASSERT_EQ(fit.exit_code, 0) << fit.err;
  EXPECT_EQ(fit.err, "");
  EXPECT_NE(fit.out.find("µg/g²"), std::string::npos);
  EXPECT_NE(fit.out.find("95 % interval (--wide)"), std::string::npos) << fit.out;
  EXPECT_EQ(fit.out.find('\x1b'), std::string::npos);
  EXPECT_EQ(read("results/result.json"), read("r.json"));
  const Json result = read_json("r.json");
  EXPECT_EQ(result["schema"], "proofmass.identification/1");
  EXPECT_EQ(result["model"], "paper");
  EXPECT_EQ(result["metrics"]["train"]["n"], 300);
  EXPECT_EQ(result["metrics"]["leave_one_out"]["n"], 300);
  EXPECT_FALSE(result["metrics"].contains("test"));
  EXPECT_EQ(result["provenance"]["options"]["split"], "1");
  EXPECT_EQ(result["provenance"]["input_sha256"].get<std::string>().size(), 64U);
  EXPECT_EQ(cells(read("results/predictions.csv")).size(), 301U);
  EXPECT_TRUE(read("results/history.csv").starts_with("curve,iteration,value\n"));
}

// Least squares and its kin fit all rows; what sets rows aside is asked for, or is another method's default.
TEST_F(IdentifyVerb, FitsAllRowsOrSetsSomeAside) {
  const std::string record = make_record();
  const auto rows = [&](const std::vector<std::string>& flags) {
    EXPECT_EQ(
        proofmass(std::vector<std::string>{"identify", record, "--json", at("r.json")} + flags).exit_code, 0);
    const Json metrics = read_json("r.json")["metrics"];
    const auto count = [&metrics](const char* part) {
      return metrics.contains(part) ? metrics[part]["n"].get<int>() : 0;
    };
    return std::array{count("train"), count("test"), count("leave_one_out")};
  };
  EXPECT_EQ(rows({"--method", "wls"}), (std::array{300, 0, 300}));
  EXPECT_EQ(rows({"--split", "0.8"}), (std::array{240, 60, 0}));
  EXPECT_EQ(rows({"--method", "gmdh"}), (std::array{210, 90, 0}));
  EXPECT_EQ(rows({"--method", "gmdh", "--split", "1"}), (std::array{300, 0, 0}));
  expect_failure(proofmass({"identify", record, "--split-by", "mount"}), 3,
                 {"column 'mount'", "--split-by row"});
}

TEST_F(IdentifyVerb, KeepsTheRowsOfAMountTogether) {
  const std::string record = at("mounts.csv");
  ASSERT_EQ(proofmass({"simulate", PROOFMASS_SOURCE_DIR "/data/mounts-24.toml", "--out", record}).exit_code,
            0);
  const std::vector<std::string> fit{"identify",       record, "--model", "full",
                                     "--on-rank-loss", "drop", "--json",  at("r.json")};
  ASSERT_EQ(proofmass(fit + std::vector<std::string>{"--split-by", "mount"}).exit_code, 0);
  EXPECT_EQ(read_json("r.json")["metrics"]["train"]["n"], 17 * 16);
  EXPECT_EQ(read_json("r.json")["metrics"]["test"]["n"], 7 * 16);
  ASSERT_EQ(proofmass(fit).exit_code, 0);
  const Json metrics = read_json("r.json")["metrics"];
  EXPECT_EQ(metrics["leave_one_out"]["n"], 384);
  EXPECT_GT(metrics["leave_one_mount_out"]["n"], 0);
  EXPECT_GT(metrics["leave_one_out"]["rmse"], metrics["train"]["rmse"]);
}

TEST_F(IdentifyVerb, GivesTheSameBytesForAnyNumberOfThreads) {
  const std::string record = make_record();
  for (const Method& method : methods()) {
    const Outcome one = proofmass(quick(record, info(method).name) +
                                  std::vector<std::string>{"--threads", "1", "--json", "-"});
    const Outcome two = proofmass(quick(record, info(method).name) +
                                  std::vector<std::string>{"--threads", "2", "--json", "-"});
    EXPECT_EQ(one.exit_code, 0) << info(method).name << ": " << one.err;
    EXPECT_EQ(one.out, two.out) << info(method).name;
  }
}

TEST_F(IdentifyVerb, SeeksTheNumberOfHiddenUnits) {
  const std::string record = make_record("200");
  const Outcome outcome = proofmass({"identify", record, "--method", "bp", "--hidden", "search", "--epochs",
                                     "5", "--search-repeats", "2", "--json", at("r.json")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto result = read_json("r.json");
  const auto& trials = result["diagnostics"]["hidden_search"];
  ASSERT_EQ(trials.size(), 10U);
  std::size_t chosen = 0;
  for (const auto& trial : trials) {
    EXPECT_EQ(trial["validation_rmse"].size(), 2U);
    EXPECT_NE(outcome.out.find(std::to_string(trial["weights"].get<int>())), std::string::npos);
    if (!trial["chosen"].get<bool>()) continue;
    ++chosen;
    EXPECT_EQ(trial["hidden"], result["network"]["hidden"]);
  }
  EXPECT_EQ(chosen, 1U);
  EXPECT_EQ(result["provenance"]["options"]["hidden"], "search");
  expect_failure(proofmass({"identify", record, "--method", "bp", "--hidden", "seek"}), 2,
                 {"--hidden", "'seek'", "or search"});
  expect_failure(
      proofmass({"identify", record, "--method", "bp", "--hidden", "search", "--validation-share", "0.001"}),
      2, {"0.001", "no validation row of 200"});
}

TEST_F(IdentifyVerb, ReadsStandardInputAndKeepsStandardOutputForTheJson) {
  make_record();
  const Outcome fit = proofmass({"identify", "-", "--json", "-"}, read("run.csv"));
  ASSERT_EQ(fit.exit_code, 0) << fit.err;
  EXPECT_EQ(Json::parse(fit.out)["method"], "ols");
}

TEST_F(IdentifyVerb, LetsFlagsOverrideThePresetInAnyOrder) {
  const std::string record = make_record();
  const auto options_of = [&](const std::vector<std::string>& more) {
    const Outcome fit = proofmass(quick(record, "pso-bp") +
                                  std::vector<std::string>{"--fitness-epochs", "1", "--json", "-"} + more);
    EXPECT_EQ(fit.exit_code, 0) << fit.err;
    return Json::parse(fit.out)["provenance"]["options"];
  };
  const Json paper = options_of({"--preset", "paper"});
  EXPECT_EQ(paper["inertia"], "0.6");
  EXPECT_EQ(paper["early-stopping"], "on");
  const Json changed = options_of({"--early-stopping", "off", "--inertia", "0.8", "--preset", "paper"});
  EXPECT_EQ(changed["inertia"], "0.8");
  EXPECT_EQ(changed["early-stopping"], "off");
  EXPECT_EQ(changed["cognitive"], paper["cognitive"]);
}

TEST_F(IdentifyVerb, StartsTheSwarmWhereItIsTold) {
  const std::string record = make_record();
  std::string line = "0.1";
  for (int k = 1; k < 28; ++k) line += "," + std::to_string(0.01 * k);
  const auto ask = [&](const std::string& content) {
    return proofmass(quick(record, "pso-bp") +
                     std::vector<std::string>{"--initial-swarm", write("swarm.csv", content), "--json", "-"});
  };
  const Outcome told = ask("# a comment\n" + line + "\n");
  ASSERT_EQ(told.exit_code, 0) << told.err;
  const Outcome random = proofmass(quick(record, "pso-bp") + std::vector<std::string>{"--json", "-"});
  EXPECT_NE(Json::parse(told.out)["history"]["swarm_mean"], Json::parse(random.out)["history"]["swarm_mean"]);
  expect_failure(ask("1,2,x\n"), 3, {"swarm.csv:1", "'x'", "number"});
  expect_failure(ask("1,2,3\n"), 2, {"28"});
  expect_failure(ask(""), 3, {"swarm.csv"});
}

TEST_F(IdentifyVerb, RefusesTermsThatCannotBeToldApartAndWritesNothing) {
  std::string text = "Ai,Ao,Ap,E\n";
  for (int k = 0; k < 40; ++k) {
    text += std::to_string(k % 7 + 1) + "," + std::to_string(k % 5) + "," + std::to_string(k % 3) + "," +
            std::to_string(k % 7 + 1 + 0.001 * (k % 4)) + "\n";
  }
  const std::string record = write("run.csv", text);
  const std::vector<std::string> ask{"identify", record,       "--terms", "K0,Ki,Kii,Koq",
                                     "--json",   at("r.json"), "--out",   at("results")};
  expect_failure(proofmass(ask), 4, {"Koq", "Kii"});
  EXPECT_EQ(names(), std::vector<std::string>{"run.csv"});
  const Outcome dropped = proofmass(ask + std::vector<std::string>{"--on-rank-loss", "drop"});
  ASSERT_EQ(dropped.exit_code, 0) << dropped.err;
  const Json lost = read_json("r.json")["coefficients"][3];
  EXPECT_EQ(lost["name"], "Koq");
  EXPECT_EQ(lost["identified"], false);
  EXPECT_FALSE(lost.contains("value"));
  EXPECT_NE(lost["reason"].get<std::string>().find("Kii"), std::string::npos);
  EXPECT_NE(dropped.out.find("Koq not identified"), std::string::npos);
}

TEST_F(IdentifyVerb, StopsWhenInterruptedAndWritesNothing) {
  const std::string record = make_record();
  for (const int signal_number : {SIGINT, SIGTERM}) {
    Process process(launch({"identify", record, "--method", "pso-bp", "--iterations", "100000000", "--json",
                            at("r.json"), "--out", at("results")}));
    while (process.is_running() && process.errors_so_far().empty()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    EXPECT_NE(process.errors_so_far().find(" of 100000000"), std::string::npos) << process.errors_so_far();
    process.send(signal_number);
    const Outcome outcome = process.wait();
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(names(), std::vector<std::string>{"run.csv"});
}

TEST_F(IdentifyVerb, ColoursOnATerminalUnlessAskedNotTo) {
  Launch program = launch({"identify", make_record()});
  EXPECT_NE(run_on_terminal(program).find("\x1b[1m"), std::string::npos);
  program.environment = {{"NO_COLOR", "1"}};
  const std::string plain = run_on_terminal(program);
  EXPECT_NE(plain.find("µrad"), std::string::npos);
  EXPECT_EQ(plain.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace proofmass::test
