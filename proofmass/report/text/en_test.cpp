// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/en.hpp"

#include <gmock/gmock.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace proofmass {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

// A finding with every figure that some sentence names.
Finding with_every_figure(Code code) {
  Finding finding{.code = code, .terms = {Term::Ki, Term::Kiii}};
  for (const char* number : {"beyond_all",
                             "beyond_asked",
                             "condition",
                             "count",
                             "digits",
                             "distance",
                             "expansion",
                             "factor",
                             "from",
                             "induced",
                             "inputs",
                             "largest",
                             "layer",
                             "least",
                             "limit",
                             "line",
                             "network",
                             "ratio",
                             "s0",
                             "s1",
                             "scale",
                             "separation",
                             "spread",
                             "test",
                             "to",
                             "total",
                             "train",
                             "tuning",
                             "typical",
                             "value",
                             "step",
                             "rounding",
                             "over_shortest_half",
                             "quantile_ratio"}) {
    finding.figures.emplace_back(number, 2.0);
  }
  for (const char* word :
       {"axes", "criterion", "inflated", "method", "named", "origin", "plan", "reason", "text", "unit"}) {
    finding.figures.emplace_back(word, "<" + std::string(word) + ">");
  }
  return finding;
}

TEST(English, HasASentenceForEachCode) {
  for (const Code code : all_codes()) {
    const std::string text = english(with_every_figure(code));
    const std::string name(to_string(code));
    EXPECT_FALSE(text.empty()) << name;
    EXPECT_THAT(text, AllOf(Not(HasSubstr("{")), Not(HasSubstr("}")), Not(HasSubstr("  ")))) << name;
    // What a figure that is missing, or not of its kind, would leave of it.
    EXPECT_THAT(text, Not(StartsWith(name))) << "names a figure that is not listed here";
  }
}

TEST(English, PutsFiguresAndTermsInTheirPlaces) {
  EXPECT_EQ(english({.code = Code::inputs_collinear,
                     .terms = {Term::Kii, Term::Koq},
                     .figures = {{"limit", 10.0}, {"inflated", std::string("Kii 23.5, Koq 17")}}}),
            "the inputs are collinear: variance inflation factors above 10 (Kii 23.5, Koq 17). The standard "
            "errors of these coefficients are large; test in more mounts to make them smaller");
  EXPECT_EQ(english({.code = Code::term_not_identified,
                     .terms = {Term::Koq},
                     .figures = {{"reason", std::string("confounded with Kii")}}}),
            "Koq is not identified: confounded with Kii");
  EXPECT_THAT(english({.code = Code::expansion_differs, .terms = {Term::K0, Term::Kiii}}),
              HasSubstr("three standard errors in K0, Kiii"));
  EXPECT_THAT(english({.code = Code::rows_without_weight,
                       .figures = {{"count", std::size_t{3}}, {"total", std::size_t{1'000'000}}}}),
              StartsWith("3 of 1000000 rows have no weight"));
}

TEST(English, GivesSentencesOfOtherVersionsAsTheyAre) {
  const std::string sentence = "100 % {sic} of {count:.0f}, \"µg/g²\"";
  EXPECT_EQ(english({.code = Code::verbatim, .figures = {{"text", sentence}}}), sentence);
}

// Files may lack figures, or have other ones than this version wrote.
TEST(English, SaysWhatItHasWhenTheSentenceLacksAFigure) {
  const Finding part{.code = Code::test_error_larger,
                     .terms = {Term::Ki},
                     .figures = {{"test", 0.25}, {"unit", std::string("mV")}, {"{odd}", 1.0}}};
  EXPECT_THAT(english(part), AllOf(HasSubstr("test_error_larger"), HasSubstr("test: 0.25"),
                                   HasSubstr("unit: mV"), HasSubstr("{odd}: 1"), HasSubstr("Ki")));
  const Finding of_another_kind{.code = Code::rows_without_weight,
                                .figures = {{"count", std::string("few")}, {"total", 10.0}}};
  EXPECT_THAT(english(of_another_kind),
              AllOf(HasSubstr("rows_without_weight"), HasSubstr("count: few"), HasSubstr("total: 10")));
  for (const Code code : all_codes()) {
    EXPECT_FALSE(english({.code = code}).empty()) << to_string(code);
    EXPECT_FALSE(english({.code = code, .figures = {{"", 1.0}, {"ratio", std::string()}}}).empty())
        << to_string(code);
  }
}

}  // namespace
}  // namespace proofmass
