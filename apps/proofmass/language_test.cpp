// SPDX-License-Identifier: Apache-2.0
// Results in Chinese.
#include <algorithm>
#include <sstream>

#include "proofmass/report/text/display_width.hpp"
#include "support/command_line.hpp"

namespace proofmass::test {
namespace {

using ChineseResults = CommandLine;

std::size_t widest_line(const std::string& text) {
  std::size_t widest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) widest = std::max(widest, display_width(line));
  return widest;
}

void expect_in(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  EXPECT_LE(widest_line(text), 80U) << text;
}

TEST_F(ChineseResults, AreTablesFindingsAndEndings) {
  const std::string record = make_record();
  const Outcome fit = proofmass({"identify", record, "--lang", "zh", "--json", at("zh.json")});
  ASSERT_EQ(fit.exit_code, 0) << fit.err;
  expect_in(fit.out, {"标准误差", "误差，单位 g", "留一法", "终止：直接求解",
                      "由双倍工作精度的正规方程直接求解", "依据：标准误差假定输入准确"});
  // Files are the same in either.
  ASSERT_EQ(proofmass({"identify", record, "--json", at("en.json")}).exit_code, 0);
  EXPECT_EQ(read("zh.json"), read("en.json"));

  const Outcome compared =
      proofmass({"compare", record, "--methods", "ols,robust", "--model", "linear", "--lang", "zh"});
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  expect_in(compared.out, {"系数，单位 g", "计算量，与 ols 之比", "robust 的依据", "收敛"});

  const Outcome seen = proofmass({"inspect", record, "--lang=zh"});
  ASSERT_EQ(seen.exit_code, 0) << seen.err;
  expect_in(seen.out, {"300 行", "最小值", "输入能够辨识的模型项", "所需行数"});
}

TEST_F(ChineseResults, AreWhatPredictSaysOfItsInputs) {
  const std::string record = make_record();
  ASSERT_EQ(proofmass({"identify", record, "--json", at("r.json")}).exit_code, 0);
  const std::string inputs = write("far.csv", "Ai,Ao,Ap\n1,0,0\n900,0,0\n");
  const Outcome chinese = proofmass({"predict", at("r.json"), inputs, "--lang", "zh"});
  ASSERT_EQ(chinese.exit_code, 0) << chinese.err;
  EXPECT_NE(chinese.err.find("proofmass: 警告：2 行中有 1 行超出辨识时的输入范围"), std::string::npos)
      << chinese.err;
  EXPECT_EQ(chinese.out, proofmass({"predict", at("r.json"), inputs}).out);
}

TEST_F(ChineseResults, AreOneOfTheLanguagesThatThereAre) {
  const Outcome other = proofmass({"inspect", make_record(), "--lang", "fr"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("--lang: found 'fr', expected one of en, zh"), std::string::npos) << other.err;
}

}  // namespace
}  // namespace proofmass::test
