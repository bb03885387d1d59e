// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/terminal/terminal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/report/number_text.hpp"
#include "proofmass/report/terminal/comparison.hpp"
#include "proofmass/report/terminal/text_table.hpp"
#include "proofmass/report/text/display_width.hpp"

namespace proofmass {
namespace {

Coefficient coefficient(Term term, double value, double standard_error) {
  Coefficient c;
  c.term = term;
  c.value = value;
  c.standard_error = standard_error;
  c.ci95 = Interval{.low = value - 2 * standard_error, .high = value + 2 * standard_error};
  c.t = value / standard_error;
  c.p = 1e-12;
  return c;
}

Finding said(std::string text, Severity severity) {
  return {.code = Code::verbatim, .severity = severity, .figures = {{"text", std::move(text)}}};
}

Identification result_in(const char* unit) {
  Identification r;
  r.method = "ols";
  r.model = "quadratic";
  r.output_unit = *find_unit(unit);
  r.coefficients = {coefficient(Term::K0, 1.30617e-5, 2.2e-8), coefficient(Term::Ki, 0.999979, 2.1e-9),
                    coefficient(Term::Kii, 4.817e-5, 3e-10), coefficient(Term::Ko, 6.87e-5, 2e-9)};
  Coefficient lost;
  lost.term = Term::Koq;
  lost.identified = false;
  lost.reason = {.code = Code::term_aliased, .terms = {Term::Koq, Term::Kii}};
  r.coefficients.push_back(lost);
  r.train = Metrics{
      .n = 70, .mae = 1e-6, .mse = 1e-12, .rmse = 1e-6, .mape_percent = 0.01, .mape_rows = 70, .r2 = 1.0};
  r.ending.parts = {{.code = EndingCode::normal_equations, .figures = {{"rows", 70.0}, {"count", 4.0}}}};
  r.findings = {said("one note", Severity::note)};
  return r;
}

std::string line_with(const std::string& text, const std::string& word) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(word) != std::string::npos) return line;
  }
  return "";
}

TEST(Terminal, ReadsCoefficientsInTheUnitsUsersSpeak) {
  const std::string text = render_table(result_in("g"));
  EXPECT_NE(line_with(text, "K0").find("13.062 ± 0.022 µg"), std::string::npos) << text;
  EXPECT_NE(line_with(text, "  Ki ").find("Ki-1 = -21.0000 ± 0.0021 ppm"), std::string::npos) << text;
  EXPECT_NE(line_with(text, "Ki ").find("0.9999790000"), std::string::npos) << text;
  EXPECT_NE(line_with(text, "Kii").find("µg/g²"), std::string::npos);
  EXPECT_NE(line_with(text, "Ko ").find("µrad"), std::string::npos);
  EXPECT_NE(text.find("Koq not identified: aliased with Kii"), std::string::npos);
  EXPECT_NE(text.find("Ended: direct"), std::string::npos);
  EXPECT_NE(text.find("note: one note"), std::string::npos);
  EXPECT_EQ(text.find("test"), std::string::npos);
}

TEST(Terminal, WarnsAboveTheCoefficientsAndNotesBelowTheErrors) {
  Identification result = result_in("g");
  result.findings = {said("first note", Severity::note), said("first warning", Severity::warning),
                     said("second note", Severity::note), said("second warning", Severity::warning)};
  const std::string text = render_table(result);
  std::vector<std::size_t> places;
  for (const char* part : {"warning: first warning", "warning: second warning", "std. error", "Errors, in g",
                           "Ended: direct", "note: first note", "note: second note"}) {
    places.push_back(text.find(part));
    ASSERT_NE(places.back(), std::string::npos) << part << " in\n" << text;
    EXPECT_EQ(text.find(part, places.back() + 1), std::string::npos) << part << " twice";
  }
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end())) << text;
}

TEST(Terminal, SaysOverWhichRowsThePercentageErrorIs) {
  Identification result = result_in("g");
  EXPECT_EQ(render_table(result).find("MAPE leaves out"), std::string::npos);
  result.train->mape_rows = 68;
  EXPECT_NE(
      line_with(render_table(result, {.width = 0}), "MAPE leaves out").find("over 68 of 70 training rows"),
      std::string::npos);
}

TEST(Terminal, SummaryIsTheTableWithoutColour) {
  const proofmass::Run run{.split = {}, .identification = result_in("g"), .provenance = {}};
  EXPECT_EQ(summary(run), render_table(run.identification));
}

TEST(Terminal, AlignsColumnsOverUnitsOfSeveralBytes) {
  EXPECT_EQ(display_width("13.0 µg/g²"), 10U);
  TextTable table({"a", "µ"});
  table.add({"xyz", "1"});
  table.add({"x", "1234"});
  EXPECT_EQ(table.lines(), (std::vector<std::string>{"  a       µ", "  xyz     1", "  x    1234"}));
}

TEST(Terminal, GivesOtherOutputsRawAndReferredToInput) {
  const std::string text = render_table(result_in("mA"));
  EXPECT_NE(line_with(text, "Kii").find("mA/g^2"), std::string::npos) << text;
  const std::size_t second = text.find("Referred to input");
  ASSERT_NE(second, std::string::npos);
  EXPECT_NE(line_with(text.substr(second), "Kii").find("µg/g²"), std::string::npos) << text;
  EXPECT_EQ(line_with(text.substr(second), "  Ki "), "") << text;
}

std::size_t longest_line(const std::string& text) {
  std::size_t longest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) longest = std::max(longest, display_width(line));
  return longest;
}

TEST(Terminal, KeepsToItsWidth) {
  Identification result = result_in("mA");
  result.findings = {said(std::string(30, 'a') + " " + std::string(60, 'b') + " c", Severity::warning)};
  EXPECT_LE(longest_line(render_table(result)), 80U) << render_table(result);
  const std::string missing = line_with(render_table(result), "not shown in 80 columns: ");
  EXPECT_TRUE(missing.ends_with("95 % interval")) << missing;
  EXPECT_NE(render_table(result, {.more_columns = "turn the page"}).find("(turn the page)\n"),
            std::string::npos);
  const std::string wide = render_table(result, {.width = 0});
  EXPECT_GT(longest_line(wide), 90U);
  EXPECT_NE(line_with(wide, "term").find("95 % interval"), std::string::npos) << wide;
  EXPECT_EQ(wide.find("not shown"), std::string::npos);
  // What it reads comes first.
  EXPECT_LT(line_with(wide, "term").find("reads"), line_with(wide, "term").find("value"));
}

TEST(Terminal, GoesOnWithColumnsThatDoNotFit) {
  TextTable table({"term", "first", "second", "third"});
  table.add({"Ki", "0.999979", "1.000021", "3"});
  std::vector<std::string> lines;
  for (const TextTable& part : table.parts(24)) {
    for (const std::string& line : part.lines()) lines.push_back(line);
  }
  EXPECT_EQ(lines, (std::vector<std::string>{"  term     first", "  Ki    0.999979",
                                             "  term    second  third", "  Ki    1.000021      3"}));
  EXPECT_EQ(table.fitting(24).columns(), 2U);
  TextTable words({"model", "unidentifiable"}, Left::last_too);
  words.add({"full", "Kii, Koq, Kiii, Kio, Kip"});
  EXPECT_EQ(words.lines(30), (std::vector<std::string>{"  model  unidentifiable",
                                                       "  full   Kii, Koq, Kiii, Kio,", "         Kip"}));
}

TEST(Terminal, ColoursOnlyWhenAsked) {
  EXPECT_EQ(render_table(result_in("g")).find('\x1b'), std::string::npos);
  EXPECT_NE(render_table(result_in("g"), {.colour = true}).find("\x1b[33m"), std::string::npos);
}

// Every line, of every kind of table.
Identification full_result(const char* unit) {
  Identification r = result_in(unit);
  r.test = r.leave_one_out = r.leave_one_mount_out = r.train;
  r.train->mape_rows = 68;
  r.diagnostics.residual_sd = 1e-6;
  r.diagnostics.dof = 66;
  r.diagnostics.r2_adjusted = 0.999;
  r.diagnostics.condition_raw = 1e3;
  r.diagnostics.condition_scaled = 1.5;
  RobustDetails robust{.scale = 1e-6, .suspect_rows = {}};
  for (std::size_t row = 1; row <= 12; ++row)
    robust.suspect_rows.push_back({.row = row, .line = row + 1, .residual = 1e-5, .scaled_residual = 9.0});
  r.details = std::move(robust);
  r.findings = {
      {.code = Code::rows_far_off,
       .severity = Severity::warning,
       .lines = {7, 9},
       .figures =
           {{"count", 2.0}, {"line", 7.0}, {"residual", 1e-3}, {"scale", 1e-6}, {"unit", std::string(unit)}}},
      {.code = Code::scale_doubtful,
       .severity = Severity::warning,
       .figures = {{"over_shortest_half", 1.9}, {"quantile_ratio", 2.5}}},
      {.code = Code::left_out_exactly},
      {.code = Code::robust_errors_asymptotic}};
  return r;
}

TEST(Terminal, SpeaksChinese) {
  const std::string text = render_table(full_result("mA"), {.language = Language::zh});
  for (const char* const part :
       {"ols，模型 quadratic，随机种子 ", "警告：2 行偏离拟合过远", "标准误差", "Koq 未辨识：与 Kii 混叠",
        "折算到输入（除以 Ki）", "误差，单位 mA", "训练集", "留一法", "MAPE 不计小于输出范围 1 % 的输出",
        "可疑行：12，以下为前 10 行", "行号", "终止：直接求解", "由双倍工作精度的正规方程直接求解：70 行数据",
        "残差标准差 1e-06 mA；自由度 66；调整 R²", "依据：全部数据行均参与拟合", "依据：标准误差为渐近值",
        "80 列宽度内未显示：p、95 % 置信区间"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
  for (const char* const english : {"warning", "rows", "term", "standard", "Ended", "not "}) {
    EXPECT_EQ(text.find(english), std::string::npos) << english << " in\n" << text;
  }
}

TEST(Terminal, KeepsToItsWidthInChinese) {
  for (const char* const unit : {"g", "mA"}) {
    for (const std::size_t width : {60U, 80U, 100U}) {
      const std::string text = render_table(full_result(unit), {.width = width, .language = Language::zh});
      EXPECT_LE(longest_line(text), width) << text;
    }
  }
}

TEST(Terminal, AlignsColumnsOverChinese) {
  TextTable table({"项", "标准误差", "值"});
  table.add({"Kii", "1", "22"});
  EXPECT_EQ(table.lines(), (std::vector<std::string>{"  项   标准误差  值", "  Kii         1  22"}));
}

Contestant contestant_named(const std::string& name, const std::vector<Finding>& findings) {
  Contestant contestant;
  contestant.method = name;
  for (int repeat = 0; repeat < 2; ++repeat) {
    Run run{.split = {}, .identification = result_in("g"), .provenance = {}};
    run.identification.findings = findings;
    contestant.runs.push_back(std::move(run));
  }
  return contestant;
}

TEST(TerminalComparison, ShowsWhatWasFoundOnTheRecordAndOnEachMethod) {
  Comparison comparison;
  comparison.repeats = 2;
  comparison.contestants = {contestant_named("least", {said("a note on least", Severity::note)}),
                            contestant_named("robust", {said("a warning on robust", Severity::warning),
                                                        said("a note on robust", Severity::note)}),
                            contestant_named("silent", {})};
  comparison.findings = {said("a doubt on the record", Severity::warning)};
  const std::string text = render_comparison(comparison);
  std::vector<std::size_t> places;
  for (const char* part :
       {"warning: a doubt on the record", "Warnings on robust", "warning: a warning on robust",
        "Coefficients, in g", "Errors, in g", "Cost, ratios to least", "Notes on least",
        "note: a note on least", "Notes on robust", "note: a note on robust"}) {
    places.push_back(text.find(part));
    ASSERT_NE(places.back(), std::string::npos) << part << " in\n" << text;
    EXPECT_EQ(text.find(part, places.back() + 1), std::string::npos) << part << " once, however many repeats";
  }
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end())) << text;
  for (const char* part : {"Warnings on least", "Warnings on silent", "Notes on silent"}) {
    EXPECT_EQ(text.find(part), std::string::npos) << part;
  }
}

TEST(TerminalComparison, SpeaksChineseInItsWidth) {
  Comparison comparison;
  comparison.repeats = 2;
  comparison.contestants = {contestant_named("least", {{.code = Code::left_out_exactly}}),
                            contestant_named("robust", {{.code = Code::robust_errors_asymptotic}})};
  comparison.contestants.front().runs.back().identification.findings.clear();
  const std::string text = render_comparison(comparison, {.language = Language::zh});
  for (const char* const part :
       {"系数，单位 g / g^阶次，随机种子 ", "误差，单位 g，2 次重复", "计算量，与 least 之比", "least 的依据",
        "（2 次重复中有 1 次）", "robust 的依据", "不可辨识", "终止"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
  EXPECT_LE(longest_line(text), 80U) << text;
}

TEST(TerminalComparison, SaysOverWhichRowsThePercentageErrorIs) {
  Comparison comparison;
  comparison.repeats = 2;
  comparison.contestants = {contestant_named("least", {}), contestant_named("robust", {})};
  EXPECT_EQ(render_comparison(comparison).find("MAPE leaves out"), std::string::npos);
  comparison.contestants.back().runs.back().identification.train->mape_rows = 68;
  EXPECT_NE(line_with(render_comparison(comparison, {.width = 0}), "MAPE leaves out")
                .find("over 68 to 70 of 70 training rows"),
            std::string::npos);
}

TEST(NumberText, ShowsTheDigitsThatMeanSomething) {
  EXPECT_EQ(uncertain_text(0.99997900123, 2.2e-9), "0.9999790012");
  EXPECT_EQ(uncertain_text(1.5, 100.0), "1.50");
  EXPECT_EQ(uncertain_text(1.5, std::nullopt), "1.50000");
  EXPECT_EQ(uncertain_text(0.0, 0.1), "0");
  EXPECT_EQ(plus_minus_text(13.0617, 0.0224), "13.062 ± 0.022");
  EXPECT_EQ(plus_minus_text(1234.5, 67.0), "1234 ± 67");
  EXPECT_EQ(plus_minus_text(2.5, 3e-17), "2.5 ± 3e-17");
  EXPECT_EQ(plus_minus_text(1e-5, 1e-22), "1e-05 ± 1e-22");
  EXPECT_EQ(plus_minus_text(0.0, 0.0), "0 ± 0");
  EXPECT_EQ(interval_text(1.30617e-5, 2.2e-9, 1.30573e-5, 1.30661e-5), "[1.30573, 1.30661]e-05");
  EXPECT_EQ(interval_text(-282554.0, 501423.0, -1285400.0, 720292.0), "[-1290000, 720000]");
  EXPECT_EQ(plus_minus_text(-0.3, 12.0), "0 ± 12");
  EXPECT_EQ(plus_minus_text(-282554.0, 501423.0), "-280000 ± 500000");
  EXPECT_EQ(plus_minus_text(1.30617e-5, 2.2e-9), "(1.30617 ± 0.00022)e-05");
  EXPECT_EQ(significant_text(120.0, 3), "120");
  EXPECT_EQ(determination_text(0.998712), "0.998712");
  EXPECT_EQ(determination_text(1.0 - 2.31e-13), "1 - 2.31e-13");
  EXPECT_EQ(determination_text(1.0), "1");
  EXPECT_EQ(determination_text(-3.5), "-3.5");
}

}  // namespace
}  // namespace proofmass
