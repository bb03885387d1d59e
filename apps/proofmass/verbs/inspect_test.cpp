// SPDX-License-Identifier: Apache-2.0
#include "support/command_line.hpp"

namespace proofmass::test {
namespace {

using InspectVerb = CommandLine;

TEST_F(InspectVerb, SummarisesARecord) {
  const Outcome seen = proofmass({"inspect", make_record(), "--json", at("i.json")});
  ASSERT_EQ(seen.exit_code, 0) << seen.err;
  EXPECT_NE(seen.out.find("300 rows"), std::string::npos);
  const Json inspection = read_json("i.json");
  EXPECT_EQ(inspection["schema"], "proofmass.inspection/1");
  EXPECT_EQ(inspection["rows"], 300);
  EXPECT_EQ(inspection["columns"][0]["name"], "Ai");
  EXPECT_EQ(inspection["models"][2]["model"], "paper");
  EXPECT_EQ(inspection["models"][2]["identified"].size(), 15U);
}

TEST_F(InspectVerb, CountsOneRowAsOne) {
  const Outcome seen = proofmass({"inspect", write("run.csv", "# Ai,E of a bench\nAi,E\n1,2\n")});
  ASSERT_EQ(seen.exit_code, 0) << seen.err;
  EXPECT_NE(seen.out.find("run.csv: 1 row\n"), std::string::npos) << seen.out;
}

TEST_F(InspectVerb, NamesTheTermsThatAMissingAxisCosts) {
  const std::string record = write("run.csv", "a;b\n1;1.1\n2;2.1\n3;3.1\n-4;-4.1\n5;5.2\n-6;-6.2\n");
  const Outcome seen = proofmass({"inspect", record, "--map", "Ai=a,E=b[mA]", "--json", "-"});
  ASSERT_EQ(seen.exit_code, 0) << seen.err;
  const Json linear = Json::parse(seen.out)["models"][0];
  EXPECT_EQ(linear["identified"], Json::parse(R"(["K0","Ki"])"));
  EXPECT_EQ(linear["lost"][0]["name"], "Ko");
}

}  // namespace
}  // namespace proofmass::test
