// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/method.hpp"
#include "support/command_line.hpp"
#include "support/quick_flags.hpp"

namespace proofmass::test {
namespace {

using PredictVerb = CommandLine;

// The test rows of predictions.csv, last first, as inputs; and what was predicted for them.
struct TestRows {
  std::string inputs = "Ai,Ao,Ap\n";
  std::vector<std::string> predicted;
};

TestRows test_rows(const std::vector<std::vector<std::string>>& table) {
  TestRows rows;
  for (std::size_t k = table.size() - 1; k > 0; --k) {
    const auto& row = table[k];  // line, part, Ai, Ao, Ap, E, E_predicted, residual
    if (row[1] != "test") continue;
    rows.inputs += row[2] + "," + row[3] + "," + row[4] + "\n";
    rows.predicted.push_back(row[6]);
  }
  return rows;
}

TEST_F(PredictVerb, RepeatsTheFitsOwnTestPredictionsToTheLastBit) {
  const std::string record = make_record();
  for (const Method& method : methods()) {
    std::vector<std::string> command{"identify", record, "--method", std::string(info(method).name),
                                     "--split",  "0.7",  "--out",    at("results")};
    const std::vector<std::string> quick = test::quick_flags(info(method).name);
    command.insert(command.end(), quick.begin(), quick.end());
    const Outcome fit = proofmass(command);
    ASSERT_EQ(fit.exit_code, 0) << info(method).name << ": " << fit.err;
    const TestRows rows = test_rows(cells(read("results/predictions.csv")));
    ASSERT_EQ(rows.predicted.size(), 90U);
    const Outcome made = proofmass({"predict", at("results/result.json"), "-"}, rows.inputs);
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const auto table = cells(made.out);
    EXPECT_EQ(table[0], (std::vector<std::string>{"Ai[g]", "Ao[g]", "Ap[g]", "E_predicted[g]"}));
    ASSERT_EQ(table.size(), 91U);
    for (std::size_t k = 0; k < rows.predicted.size(); ++k) {
      EXPECT_EQ(table[k + 1][3], rows.predicted[k]) << info(method).name;
    }
  }
}

TEST_F(PredictVerb, AnswersInTheDeclaredUnit) {
  const std::string record =
      write("run.csv", "Ai[m/s^2],E[mg]\n0,0.5\n9.80665,1000.5\n-9.80665,-999.5\n19.6133,2000.5\n");
  const Outcome fit =
      proofmass({"identify", record, "--terms", "K0,Ki", "--split", "1", "--json", at("r.json")});
  ASSERT_EQ(fit.exit_code, 0) << fit.err;
  const Outcome made = proofmass(
      {"predict", at("r.json"), write("in.csv", "a\n2\n"), "--map", "Ai=a", "--out", at("out.csv")});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const auto table = cells(read("out.csv"));
  EXPECT_EQ(table[0], (std::vector<std::string>{"Ai[g]", "E_predicted[mg]"}));
  EXPECT_NEAR(std::stod(table[1][1]), 2000.5, 1e-9);
}

TEST_F(PredictVerb, NamesWhatIsWrongWithItsInputs) {
  const std::string record = make_record();
  ASSERT_EQ(proofmass({"identify", record, "--json", at("r.json")}).exit_code, 0);
  const std::string one_axis = write("in.csv", "Ai\n1\n");
  expect_failure(proofmass({"predict", at("r.json"), one_axis}), 3, {"Ao"});
  expect_failure(proofmass({"predict", record, record}), 3, {"run.csv", "not JSON"});
  expect_failure(proofmass({"predict", at("none.json"), record}), 3, {"none.json"});
  expect_failure(proofmass({"predict", "-", "-"}), 2, {"standard input"});
  Json cut = read_json("r.json");
  cut["coefficients"][0].erase("value");
  expect_failure(proofmass({"predict", write("cut.json", cut.dump()), record, "--out", at("out.csv")}), 3,
                 {"cut.json", "'coefficients[0].value' is missing"});
  EXPECT_FALSE(exists("out.csv"));
}

}  // namespace
}  // namespace proofmass::test
