// SPDX-License-Identifier: Apache-2.0
// Results and errors in Chinese.
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

class ChineseErrors : public CommandLine {
 protected:
  // The same words twice: English as it always was, and Chinese.
  void expect_error(std::vector<std::string> words, int exit_code, const std::string& english,
                    const std::string& chinese) {
    const Outcome in_english = proofmass(words);
    EXPECT_EQ(in_english.exit_code, exit_code);
    EXPECT_EQ(in_english.err, "proofmass: error: " + english + "\n");
    words.insert(words.end(), {"--lang", "zh"});
    const Outcome in_chinese = proofmass(words);
    EXPECT_EQ(in_chinese.exit_code, exit_code);
    EXPECT_EQ(in_chinese.err, "proofmass: 错误：" + chinese + "\n");
    EXPECT_EQ(in_chinese.out, "");
  }
};

TEST_F(ChineseErrors, AreThoseOfTheCommandLine) {
  const std::string record = make_record();
  expect_error({"inspect", record, "--overlaod", "refuse"}, 2,
               "The following arguments were not expected: refuse --overlaod; did you mean --overload? (see "
               "proofmass inspect --help)",
               "多余的参数：refuse --overlaod；是否想写 --overload？（见 proofmass inspect --help）");
  expect_error({"identify", record, "--method", "olss"}, 2,
               "unknown method 'olss'; expected one of ols, wls, robust, bp, pso-bp, tls, eiv, hybrid, "
               "gmdh, afsa; did you mean ols?",
               "未知的方法 'olss'；应为下列之一：ols, wls, robust, bp, pso-bp, tls, eiv, hybrid, "
               "gmdh, afsa；是否想写 ols？");
  expect_error({"identify", record, "--split", "1.5"}, 2,
               "--split: found '1.5', expected a number more than 0 and at most 1, or default",
               "--split：实为 '1.5'，应为大于 0 且不大于 1 的数值，或 default");
  expect_error({"identify"}, 2, "RUN.csv is required (see proofmass identify --help)",
               "缺少 RUN.csv（见 proofmass identify --help）");
}

TEST_F(ChineseErrors, AreThoseOfRecords) {
  const std::string bad = write("bad.csv", "Ai,Ao,Ap,E\n1,0,0,1\n0,1,0,a\x01z\n");
  expect_error({"inspect", bad}, 3,
               bad +
                   ":3: found '0,1,0,a\\x01z', expected text without control characters, "
                   "not a binary file",
               bad + " 第 3 行：实为 '0,1,0,a\\x01z'，应为不含控制字符的文本，而不是二进制文件");
  const std::string word = write("word.csv", "Ai,Ao,Ap,E\n1,0,0,1\n0,1,0,abc\n");
  expect_error({"identify", word}, 3, word + ":3: column 'E': found 'abc', expected a number",
               word + " 第 3 行：列 'E'：实为 'abc'，应为数值");
  const std::string missing = write("missing.csv", "Ao,Ap,E\n0,0,1\n");
  expect_error({"identify", missing}, 3,
               missing +
                   ":1: column 'Ai': found 'Ao Ap E', expected a column named Ai; columns are separated "
                   "by comma, semicolon, tab, | or blanks\ntry: --map Ai=NAME",
               missing +
                   " 第 1 行：列 'Ai'：实为 'Ao Ap E'，应为名为 Ai 的列；各列以逗号、分号、制表符、| "
                   "或空格分隔\n可尝试：--map Ai=NAME");
  const std::string absent = at("absent.csv");
  expect_error({"identify", absent}, 3, "cannot open " + absent + ": no such file or directory",
               "不能打开 " + absent + "：没有该文件或文件夹");
}

TEST_F(ChineseErrors, AreRefusals) {
  const std::string record =
      write("flat.csv", "Ai,Ao,Ap,E\n1,0,0,1\n2,0,0,2\n3,0,0,3.1\n4,0,0,4\n5,0,0,5\n6,0,0,6\n");
  expect_error({"identify", record, "--terms", "K0,Ki,Ko"}, 4,
               record +
                   ": the inputs cannot identify 1 of the 3 terms asked for: Ko. Fit without them, ask for "
                   "fewer terms, or test in more mounts\n  Ko is not identified: Ao is zero in every "
                   "row\ntry: --on-rank-loss drop or --terms K0,Ki",
               record +
                   "：在所要求的 3 项中，输入不能辨识 1 项：Ko。请不拟合这些项、减少所要求的项，或在更多"
                   "安装位置上试验\n  Ko 不可辨识：Ao 在各行中均为零\n可尝试：--on-rank-loss drop 或 "
                   "--terms K0,Ki");
}

TEST_F(ChineseErrors, AreThoseOfResults) {
  const std::string result = write("r.json", "{\"schema\": 3}");
  const std::string inputs = write("in.csv", "Ai,Ao,Ap\n1,0,0\n");
  expect_error({"predict", result, inputs}, 3, result + ": key 'schema': found 3, expected a string",
               result + "：键 'schema'：实为 3，应为字符串");
}

}  // namespace
}  // namespace proofmass::test
