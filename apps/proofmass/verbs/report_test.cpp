// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <nlohmann/json.hpp>

#include "proofmass/identify/method.hpp"
#include "support/command_line.hpp"
#include "support/quick_flags.hpp"

namespace proofmass::test {
namespace {

namespace fs = std::filesystem;

class ReportVerb : public CommandLine {
 protected:
  // A record of 120 rows and a result of it, in the folder of the test.
  std::string make_result() {
    const std::string record = make_record("120");
    const Outcome made = proofmass({"identify", record, "--model", "quadratic", "--json", at("result.json")});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    return record;
  }
  Outcome report(const std::vector<std::string>& more = {}) {
    std::vector<std::string> command{"report", at("result.json"), "--out", at("report.html")};
    command.insert(command.end(), more.begin(), more.end());
    return proofmass(command);
  }
};

// Row by row the same figures: the split is found again from the options.
TEST_F(ReportVerb, IsThePageThatIdentifyWrites) {
  const std::string record = make_record("300");
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{"--method", "ols"},
        {"--method", "ols", "--split", "0.6", "--seed", "9"},
        {"--method", "bp", "--early-stopping", "on", "--epochs", "30"},
        {"--method", "gmdh"}}) {
    std::vector<std::string> command{"identify",        record,     "--model",       "linear", "--json",
                                     at("result.json"), "--report", at("first.html")};
    command.insert(command.end(), options.begin(), options.end());
    ASSERT_EQ(proofmass(command).exit_code, 0);
    const Outcome made = report();
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_EQ(made.err, "");
    EXPECT_EQ(read("first.html"), read("report.html")) << options[1];
  }
}

TEST_F(ReportVerb, SaysWhyFiguresOfRowsAreAbsent) {
  const std::string record = make_result();
  fs::rename(record, at("moved.csv"));
  const Outcome absent = report();
  EXPECT_EQ(absent.exit_code, 0);
  EXPECT_NE(absent.err.find("is not where it was"), std::string::npos);
  EXPECT_NE(read("report.html").find("is not where it was"), std::string::npos);
  EXPECT_EQ(report({"--record", at("moved.csv")}).err, "");
  EXPECT_NE(read("report.html").find("figure-residuals-ai"), std::string::npos);
  write(fs::path(record).filename().string(), "no record any more");
  const Outcome changed = report();
  EXPECT_EQ(changed.exit_code, 0) << changed.err;
  EXPECT_NE(changed.err.find("has changed since"), std::string::npos);
  expect_failure(report({"--record", record}), 3, {"is not the record", "SHA-256"});
  expect_failure(report({"--record", at("none.csv")}), 3, {"none.csv"});
}

// Coefficients that were changed by hand do not have the errors that the result says.
TEST_F(ReportVerb, RefusesCoefficientsThatAreNotThoseOfTheScores) {
  make_result();
  auto changed = nlohmann::json::parse(read("result.json"));
  for (auto& coefficient : changed["coefficients"]) {
    if (coefficient["name"] != "Ki") continue;
    coefficient["value"] = 1.01;
    coefficient["ci95"] = {1.0, 1.02};
  }
  write("result.json", changed.dump());
  expect_failure(report(), 3, {"training error", "the result file was changed"});
}

TEST_F(ReportVerb, NeverDestroysWhatItReads) {
  const std::string record = make_result();
  const std::string before = read(fs::path(record).filename().string());
  expect_failure(proofmass({"report", at("result.json"), "--out", record}), 2, {"is an input"});
  expect_failure(proofmass({"report", at("result.json"), "--out", at("result.json")}), 2, {"is an input"});
  EXPECT_EQ(read(fs::path(record).filename().string()), before);
}

TEST_F(ReportVerb, RefusesAResultWhoseOptionsContradictIt) {
  make_result();
  std::string json = read("result.json");
  const std::string split = "\"split\": \"1\"";
  const std::size_t at_split = json.find(split);
  ASSERT_NE(at_split, std::string::npos);
  for (const char* value : {"\"split\": \"7\"", "\"split\": \"x\"", "\"split\": \"0.5\""}) {
    std::string changed = json;
    write("result.json", changed.replace(at_split, split.size(), value));
    expect_failure(report(), 3, {"contradicts the result"});
  }
}

TEST_F(ReportVerb, EndsOnAResultOfAnyDepth) {
  make_result();
  std::string json = read("result.json");
  const std::size_t details = json.find("\"details\": [");
  ASSERT_NE(details, std::string::npos);
  std::string deep;
  for (int k = 0; k < 300; ++k) deep += R"({"code": "training", "figures": {}, "parts": [)";
  for (int k = 0; k < 300; ++k) deep += "]}";
  json.insert(details + 12, deep + ",");
  write("result.json", json);
  EXPECT_EQ(report().exit_code, 0);
}

TEST_F(ReportVerb, GivesEachOutputAFileOfItsOwn) {
  const std::string record = make_record("120");
  const std::string both = at("both");
  expect_failure(proofmass({"identify", record, "--json", both, "--report", both}), 2, {"written twice"});
  expect_failure(proofmass({"identify", record, "--json", "-", "--report", "-"}), 2, {"written twice"});
  expect_failure(proofmass({"identify", record, "--out", at("o"), "--report", at("o/result.json")}), 2,
                 {"o"});
  expect_failure(proofmass({"compare", record, "--methods", "ols", "--json", both, "--report", both}), 2,
                 {"written twice"});
  EXPECT_FALSE(fs::exists(both));
}

// The folder is made for both; a page names what was not used of the record.
TEST_F(ReportVerb, WritesIntoTheFolderOfTheOtherOutputs) {
  const std::string record =
      write("more.csv",
            "Ai,Ao,Ap,E,rpm,<i>\n1,0,0,1.1,5,6\n-1,0,0,-0.9,5,6\n0,1,0,0.1,5,6\n0,0,1,0.12,5,6\n"
            "0,-1,0,0.11,5,6\n0,0,-1,0.1,5,6\n1,0,0,1.11,5,6\n");
  const fs::path folder = fs::path(at("new")) / "folder";
  const Outcome made = proofmass({"identify", record, "--model", "linear", "--out", folder.string(),
                                  "--report", (folder / "report.html").string()});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  const std::string page = read("new/folder/report.html");
  EXPECT_NE(page.find("2 columns of the file are not used: rpm, &lt;i&gt;"), std::string::npos);
  EXPECT_NE(page.find("文件中有 2 列未使用：rpm、&lt;i&gt;"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "result.json"));
}

}  // namespace
}  // namespace proofmass::test
