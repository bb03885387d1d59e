// SPDX-License-Identifier: Apache-2.0
#include "support/command_line.hpp"

namespace proofmass::test {
namespace {

using CompareVerb = CommandLine;

const std::vector<std::string> kEveryMethod{"ols",  "wls",  "robust", "tls",    "eiv",
                                            "gmdh", "afsa", "bp",     "pso-bp", "hybrid"};

std::string joined(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ",") + name;
  return list;
}

TEST_F(CompareVerb, PutsEveryMethodSideBySide) {
  const std::string record = make_record("200");
  const std::vector<std::string> small{"--epochs",          "20", "--particles",       "6",
                                       "--iterations",      "3",  "--refine",          "2",
                                       "--fish-iterations", "5",  "--model",           "quadratic",
                                       "--sigma-input-ug",  "1",  "--sigma-output-ug", "10"};
  std::vector<std::string> command{"compare", record,      "--methods", joined(kEveryMethod),
                                   "--json",  at("c.json")};
  command.insert(command.end(), small.begin(), small.end());
  const Outcome outcome = proofmass(command);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json comparison = read_json("c.json");
  EXPECT_EQ(comparison["schema"], "proofmass.comparison/1");
  ASSERT_EQ(comparison["methods"].size(), kEveryMethod.size());
  for (std::size_t k = 0; k < kEveryMethod.size(); ++k) {
    const Json& method = comparison["methods"][k];
    EXPECT_EQ(method["method"], kEveryMethod[k]);
    EXPECT_EQ(method["runs"].at(0)["metrics"]["test"]["n"], 60);
    EXPECT_FALSE(method.contains("truth"));
    EXPECT_NE(outcome.out.find(kEveryMethod[k]), std::string::npos);
  }
  for (const char* text : {"Kop", "MAPE", "R²", "time ratio"}) {
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
  }
}

TEST_F(CompareVerb, SaysOverWhichRowsThePercentageErrorIs) {
  std::string rows = "Ai,E\n";
  for (int k = -20; k <= 20; ++k) {
    rows += std::to_string(k) + "," + std::to_string(1.01 * k + 1e-3 * (k % 3)) + "\n";
  }
  const Outcome outcome = proofmass({"compare", write("run.csv", rows), "--methods", "ols,robust", "--terms",
                                     "K0,Ki", "--split", "1", "--json", at("c.json"), "--wide"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("it is over 40 of 41 training rows"), std::string::npos) << outcome.out;
  const Json comparison = read_json("c.json");
  for (const Json& method : comparison["methods"]) {
    EXPECT_EQ(method["train"]["n"]["mean"], 41);
    EXPECT_EQ(method["train"]["mape_rows"]["mean"], 40);
  }
}

TEST_F(CompareVerb, MeasuresTheDistanceFromTheTruth) {
  const std::string record = make_record("2000");
  const std::string truth = PROOFMASS_SOURCE_DIR "/data/twin-10ug.toml";
  const Outcome outcome = proofmass({"compare", record, "--methods", "ols,wls", "--repeats", "3", "--truth",
                                     truth, "--json", at("c.json")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("rms error / bound"), std::string::npos);
  const Json comparison = read_json("c.json");
  for (const Json& method : comparison["methods"]) {
    const double over_bound = method["truth"]["rms_error_over_bound"];
    // One record's noise: chi-square of 15 terms over 15, and standard errors know sigma to 2 %.
    EXPECT_GT(over_bound, 0.5);
    EXPECT_LT(over_bound, 1.6);
    EXPECT_NEAR(method["truth"]["rms_error_over_standard_error"].get<double>() / over_bound, 1.0, 0.1);
  }
}

TEST_F(CompareVerb, DoubtsATruthThatIsNotTheRecords) {
  const std::string record = make_record("500");
  const auto notes_with = [&](const std::string& truth) {
    const Outcome outcome = proofmass(
        {"compare", record, "--methods", "ols", "--truth", truth, "--wide", "--json", at("c.json")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json notes = read_json("c.json").value("notes", Json::array());
    for (const std::string note : notes) EXPECT_NE(outcome.out.find("warning: " + note), std::string::npos);
    return notes.dump();
  };
  EXPECT_EQ(notes_with(write("twin.toml", read_file(PROOFMASS_SOURCE_DIR "/data/twin-10ug.toml"))), "[]");
  const std::string other = notes_with(PROOFMASS_SOURCE_DIR "/data/twin-300ug.toml");
  EXPECT_NE(other.find("simulated from twin.toml, the truth is twin-300ug.toml"), std::string::npos) << other;
  EXPECT_NE(other.find("times as far from the truth's as its noise explains"), std::string::npos) << other;
}

TEST_F(CompareVerb, GivesCostsAndTheirRatios) {
  const std::string record = make_record("300");
  ASSERT_EQ(proofmass({"compare", record, "--methods", "robust,gmdh,afsa,ols", "--fish-iterations", "5",
                       "--model", "full", "--json", at("c.json")})
                .exit_code,
            0);
  const Json methods = read_json("c.json")["methods"];
  EXPECT_EQ(methods[0]["ratios"]["iterations"], 1.0);
  for (const std::size_t k : {1U, 2U}) {
    const Json& ratios = methods[k]["ratios"];
    const double iterations = methods[k]["iterations"]["mean"];
    EXPECT_GT(iterations, 0.0);
    EXPECT_DOUBLE_EQ(ratios["iterations"], iterations / methods[0]["iterations"]["mean"].get<double>());
    EXPECT_GT(ratios["seconds"], 0.0);
    EXPECT_GT(ratios["test_mse"], 0.0);
  }
  EXPECT_FALSE(methods[3].contains("iterations"));
}

TEST_F(CompareVerb, RefusesWhatMakesNoSenseAndWritesNothing) {
  const std::string record = make_record("60");
  expect_failure(proofmass({"compare", record}), 2, {"--methods"});
  expect_failure(proofmass({"compare", record, "--methods", "ols,magic"}), 2, {"magic", "pso-bp"});
  expect_failure(proofmass({"compare", record, "--methods", "ols,,wls"}), 2, {"--methods", "empty"});
  expect_failure(proofmass({"compare", record, "--methods", "ols", "--truth", ""}), 2, {"--truth", "empty"});
  expect_failure(proofmass({"compare", record, "--methods", "ols,ols"}), 2, {"'ols' is listed twice"});
  expect_failure(proofmass({"compare", record, "--methods", "ols", "--repeats", "0"}), 2, {"--repeats"});
  expect_failure(proofmass({"compare", record, "--methods", "ols,eiv", "--json", at("c.json")}), 4,
                 {"eiv needs", "--sigma-output-ug X --sigma-input-ug X"});
  expect_failure(proofmass({"compare", record, "--methods", "ols", "--truth", at("none.toml")}), 3,
                 {"none.toml"});
  expect_failure(proofmass({"compare", record, "--methods", "ols", "--json", record}), 2, {"run.csv"});
  EXPECT_EQ(names(), std::vector<std::string>{"run.csv"});
}

}  // namespace
}  // namespace proofmass::test
