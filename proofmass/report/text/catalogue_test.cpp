// SPDX-License-Identifier: Apache-2.0
// Every sentence in every language, with the same figures.
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "proofmass/core/utf8.hpp"
#include "proofmass/report/text/endings.hpp"
#include "proofmass/report/text/findings.hpp"
#include "proofmass/report/text/label.hpp"
#include "proofmass/report/text/templates_internal.hpp"

namespace proofmass {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

using Placeholders = std::map<std::string, std::set<std::string>>;

// The figures by name, each with the formats that it has; plural forms do not count.
Placeholders placeholders(std::string_view words) {
  static const std::regex kPlaceholder(R"(\{(\w+)(:[^}]*)?\})");
  Placeholders found;
  const std::string text(words);
  for (std::sregex_iterator at(text.begin(), text.end(), kPlaceholder), end; at != end; ++at) {
    if (const std::string format = (*at)[2]; !format.starts_with(":?")) found[(*at)[1]].insert(format);
  }
  return found;
}

bool is_chinese(std::string_view character) { return character >= "\u4e00" && character <= "\u9fff"; }

std::vector<std::string> characters(std::string_view text) {
  std::vector<std::string> all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_length(text.substr(at));
    if (length == 0) throw std::invalid_argument("no UTF-8: " + std::string(text));
    all.emplace_back(text.substr(at, length));
    at += length;
  }
  return all;
}

void expect_chinese(std::string_view words) {
  SCOPED_TRACE(words);
  const std::vector<std::string> text = characters(words);
  EXPECT_TRUE(std::any_of(text.begin(), text.end(), is_chinese));
  static const std::set<std::string> kAscii{",", ".", ";", ":", "(", ")", "?"};
  for (std::size_t k = 1; k < text.size(); ++k) {
    EXPECT_FALSE(is_chinese(text[k - 1]) && kAscii.contains(text[k])) << text[k - 1] << text[k];
    EXPECT_FALSE(is_chinese(text[k]) && kAscii.contains(text[k - 1])) << text[k - 1] << text[k];
  }
  EXPECT_THAT(std::string(words), Not(HasSubstr("  ")));
  EXPECT_THAT(std::string(words), Not(HasSubstr("。。")));
}

void expect_same(std::string_view english, std::string_view chinese) {
  SCOPED_TRACE(english);
  EXPECT_FALSE(english.empty());
  EXPECT_FALSE(chinese.empty());
  EXPECT_EQ(placeholders(english), placeholders(chinese));
}

// What has no words of a language in it: symbols and figures alone.
bool is_symbolic(std::string_view words) {
  const std::string rest = std::regex_replace(std::string(words), std::regex(R"(\{[^}]*\})"), "");
  return std::none_of(rest.begin(), rest.end(),
                      [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
}

TEST(Catalogue, SaysEachFindingWithTheSameFiguresInEachLanguage) {
  for (const Code code : all_codes()) {
    SCOPED_TRACE(to_string(code));
    const std::string_view english = english_template(code);
    const std::string_view chinese = chinese_template(code);
    EXPECT_EQ(english.empty(), chinese.empty());
    if (english.empty()) continue;  // its reason is tested below
    expect_same(english, chinese);
    if (!is_symbolic(english)) expect_chinese(chinese);
  }
  expect_same(english_scale_of_few_rows(), chinese_scale_of_few_rows());
  expect_chinese(chinese_scale_of_few_rows());
}

TEST(Catalogue, HasEachPhraseInEachLanguage) {
  std::vector<NamedPhrase> phrases(english_diagnosis_phrases().begin(), english_diagnosis_phrases().end());
  for (const char* const word : {"press", "regularity", "unbiasedness"})
    phrases.push_back({"criterion", word, english_phrase("criterion", word)});
  for (const char* const word : {"given", "default", "estimated"})
    phrases.push_back({"origin", word, english_phrase("origin", word)});
  for (const NamedPhrase& phrase : phrases) {
    SCOPED_TRACE(std::string(phrase.figure) + " " + std::string(phrase.word));
    const std::string_view chinese = chinese_phrase(phrase.figure, phrase.word);
    expect_same(phrase.phrase, chinese);
    if (!is_symbolic(phrase.phrase)) expect_chinese(chinese);
  }
}

TEST(Catalogue, SaysEachEndingWithTheSameFiguresInEachLanguage) {
  for (const EndingCode code : all_ending_codes()) {
    SCOPED_TRACE(to_string(code));
    EXPECT_EQ(find_ending_code(to_string(code)), code);
    const Words words = ending_words(code);
    expect_same(words.en, words.zh);
    if (!is_symbolic(words.en)) expect_chinese(words.zh);
  }
  EXPECT_EQ(find_ending_code("no such code"), std::nullopt);
}

// Figures in the places of the others: a number for each, another for each name.
std::vector<Finding> reasons() {
  const std::vector<Figure> figures{{"column", std::string("Ap")},
                                    {"product", std::string("Ai*Ao")},
                                    {"step", 0.001},
                                    {"sigma", 0.002},
                                    {"with", 0.003},
                                    {"without", 0.004},
                                    {"unit", std::string("mV")},
                                    {"rows", 5.0}};
  std::vector<Finding> all;
  for (const Code code : all_codes()) {
    if (!english_template(code).empty()) continue;
    for (const TermList& terms : {TermList{Term::Koo, Term::K0, Term::Kii}, TermList{Term::Koo, Term::K0},
                                  TermList{Term::Koq, Term::Kii}, TermList{Term::Koo}}) {
      all.push_back({.code = code, .terms = terms, .figures = figures});
      all.push_back(all.back());
      all.back().figures.emplace_back("count", 70.0);
      all.back().figures.emplace_back("total", 80.0);
    }
  }
  return all;
}

// Numbers, names of terms and units.
std::multiset<std::string> figures_in(const std::string& text) {
  static const std::regex kFigure(R"([0-9.]*[0-9]|K[iop0]+|Ap|mV)");
  return {std::sregex_token_iterator(text.begin(), text.end(), kFigure), std::sregex_token_iterator()};
}

TEST(Catalogue, SaysWhyTermsAreNotIdentifiedWithTheSameFiguresInEachLanguage) {
  const std::vector<Finding> all = reasons();
  EXPECT_EQ(all.size(), 8U * 8U);
  for (const Finding& finding : all) {
    SCOPED_TRACE(sentence(finding, Language::en));
    using Say = std::string (*)(const Finding&, Language);
    for (const Say say : {static_cast<Say>(sentence), static_cast<Say>(reason)}) {
      const std::string chinese = say(finding, Language::zh);
      expect_chinese(chinese);
      EXPECT_EQ(figures_in(chinese), figures_in(say(finding, Language::en))) << chinese;
    }
  }
}

TEST(Catalogue, PutsFiguresAndListsInTheirPlacesInChinese) {
  EXPECT_THAT(sentence({.code = Code::inputs_collinear,
                        .figures = {{"limit", 10.0}, {"inflated", std::string("Kii 23.5, Koq 17, Kp 11")}}},
                       Language::zh),
              HasSubstr("方差膨胀因子大于 10（Kii 23.5、Koq 17、Kp 11）"));
  EXPECT_EQ(
      sentence({.code = Code::term_aliased, .terms = {Term::Koo, Term::K0, Term::Kii}}, Language::zh),
      "Koo 不可辨识：与 K0、Kii 混叠，因为在这些行中 Ao^2 是 1、Ai^2 的线性组合；其影响全部计入 K0、Kii "
      "的值");
  EXPECT_EQ(sentence({.code = Code::rows_without_weight, .figures = {{"count", 3.0}, {"total", 1e6}}},
                     Language::zh),
            "1000000 行中有 3 行的 sigma_E 远大于其他行，实际上不起作用：不计入自由度");
  EXPECT_EQ(sentence({.code = Code::record_empty_rows_skipped, .lines = {4, 9}, .figures = {{"count", 12.0}}},
                     Language::zh),
            "已跳过 12 个字段全空的行：第 4、9…… 行");
  EXPECT_THAT(
      sentence({.code = Code::layers_short_of_optimum, .figures = {{"ratio", std::string("infinite")}}},
               Language::zh),
      HasSubstr("无穷大"));
  EXPECT_EQ(
      sentence({.code = Code::verbatim, .figures = {{"text", std::string("{old} words")}}}, Language::zh),
      "{old} words");
}

TEST(Catalogue, SaysEndingsWithPartsWithinParts) {
  const std::vector<EndingPart> parts{
      {.code = EndingCode::particle_swarm,
       .parts = {{.code = EndingCode::swarm_spent, .figures = {{"iterations", 60.0}}}}},
      {.code = EndingCode::training,
       .parts = {{.code = EndingCode::best_candidate,
                  .figures = {{"epochs", 1.0}, {"candidates", 2.0}},
                  .parts = {{.code = EndingCode::epochs_spent}}}}}};
  EXPECT_EQ(
      sentence(parts, Language::en),
      "swarm: all 60 iterations spent; training: the epochs allowed are spent (1 epoch of the best of 2 "
      "candidates)");
  EXPECT_EQ(sentence(parts, Language::zh),
            "粒子群：60 次迭代已全部用完；训练：允许的训练轮次已用完（2 个候选网络中最优者，训练 1 个轮次）");
  // Of a file that lacks a figure.
  const std::vector<EndingPart> part{{.code = EndingCode::swarm_spent, .figures = {{"rounds", 3.0}}}};
  EXPECT_EQ(sentence(part, Language::zh), "swarm_spent; rounds: 3");
}

TEST(Catalogue, HasEachLabelInEachLanguage) {
  for (const Label label : all_labels()) {
    const Words both = words(label);
    EXPECT_FALSE(both.en.empty());
    EXPECT_EQ(placeholders(both.en), placeholders(both.zh)) << both.en;
    EXPECT_EQ(both.en.ends_with('.'), both.zh.ends_with("。")) << both.en;
    expect_chinese(both.zh);
  }
}

}  // namespace
}  // namespace proofmass
