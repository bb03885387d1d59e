// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/en.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
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
                             "rows",
                             "first",
                             "second",
                             "with",
                             "without",
                             "over_shortest_half",
                             "quantile_ratio",
                             "largest",
                             "repeats",
                             "longest",
                             "last",
                             "bits",
                             "turn",
                             "before",
                             "after",
                             "line",
                             "residual",
                             "expected",
                             "angle",
                             "ko",
                             "kp",
                             "percent",
                             "original",
                             "ki",
                             "dof",
                             "r2",
                             "errors",
                             "change",
                             "mean",
                             "correlation",
                             "shift",
                             "sigma",
                             "others",
                             "middle",
                             "large",
                             "small"}) {
    finding.figures.emplace_back(number, 2.0);
  }
  for (const char* word : {"axes",  "column",     "columns", "encoding", "criterion", "inflated", "method",
                           "named", "origin",     "read",    "written",  "which",     "hint",     "reason",
                           "mount", "magnitudes", "size",    "within",   "plan",      "product",  "text",
                           "unit",  "axis",       "shape",   "function", "direction", "course",   "weight"}) {
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
  EXPECT_THAT(english({.code = Code::expansion_differs, .terms = {Term::K0, Term::Kiii}}),
              HasSubstr("three standard errors in K0, Kiii"));
  EXPECT_THAT(english({.code = Code::rows_without_weight,
                       .figures = {{"count", std::size_t{3}}, {"total", std::size_t{1'000'000}}}}),
              StartsWith("3 of 1000000 rows have no weight"));
}

// One row has, two rows have: of every count that may be one.
TEST(English, CountsOneAsOne) {
  for (const Code code : all_codes()) {
    const bool several = code == Code::output_clipped || code == Code::output_saturated ||
                         code == Code::output_repeated || code == Code::output_stuck ||
                         code == Code::sigma_output_uneven;
    if (several) continue;  // never one row
    Finding one{.code = code, .terms = {Term::Ki, Term::Kiii}, .lines = {7}};
    for (Figure figure : with_every_figure(code).figures) {
      if (std::holds_alternative<double>(figure.value)) figure.value = figure.name == "total" ? 9.0 : 1.0;
      one.figures.push_back(std::move(figure));
    }
    const std::string text = english(one);
    for (const char* const wrong :
         {"1 rows repeat", "1 rows have", "1 rows are", "1 rows lie", "1 lines", "1 pairs", "1 comment lines",
          "1 repetitions", "1 degrees", "1 inputs", "lines 7"}) {
      EXPECT_THAT(text, Not(HasSubstr(wrong))) << to_string(code);
    }
  }
  EXPECT_EQ(english({.code = Code::record_preamble_skipped, .lines = {1}, .figures = {{"count", 1.0}}}),
            "1 line above the header is skipped: 1");
  EXPECT_EQ(english({.code = Code::record_preamble_skipped, .lines = {1, 2}, .figures = {{"count", 2.0}}}),
            "2 lines above the header are skipped: 1, 2");
  EXPECT_THAT(english({.code = Code::rows_without_weight, .figures = {{"count", 1.0}, {"total", 9.0}}}),
              StartsWith("1 of 9 rows has no weight beside the others, because its sigma_E"));
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
                                .figures = {{"count", std::string("{few}")}, {"total", 10.0}}};
  EXPECT_THAT(english(of_another_kind), StartsWith("{few} of 10 rows have no weight"));
  for (const Code code : all_codes()) {
    EXPECT_FALSE(english({.code = code}).empty()) << to_string(code);
    EXPECT_FALSE(english({.code = code, .figures = {{"", 1.0}, {"ratio", std::string()}}}).empty())
        << to_string(code);
  }
}

// Terms that are not identified: the first of the finding's.
TEST(English, SaysWhyATermIsNotIdentified) {
  const Finding bucking{.code = Code::term_aliased, .terms = {Term::Koq, Term::Kii}};
  EXPECT_EQ(english_reason(bucking), "aliased with Kii: over these rows |Ai|*Ai is proportional to Ai^2");
  EXPECT_EQ(english(bucking), "Koq is not identified: " + english_reason(bucking) +
                                  "; whatever it contributes is in the value of Kii");
  EXPECT_EQ(english_reason({.code = Code::term_aliased, .terms = {Term::Koo, Term::K0, Term::Kii}}),
            "aliased with K0, Kii: over these rows Ao^2 is a combination of 1, Ai^2");
  EXPECT_EQ(english_reason({.code = Code::term_aliased, .terms = {Term::Ko, Term::K0}}),
            "aliased with K0: Ao is the same in every row");
  EXPECT_EQ(english_reason({.code = Code::term_without_column,
                            .terms = {Term::Kp},
                            .figures = {{"column", std::string("Ap")}}}),
            "the record has no column Ap");
  EXPECT_EQ(english_reason({.code = Code::term_input_zero,
                            .terms = {Term::Kio},
                            .figures = {{"product", std::string("Ai*Ao")},
                                        {"count", std::size_t{270}},
                                        {"total", std::size_t{300}}}}),
            "Ai*Ao is zero in every row (among the 270 of 300 rows that have weight)");
  EXPECT_THAT(english_reason({.code = Code::term_hidden_by_rounding,
                              .terms = {Term::Koo, Term::K0, Term::Kii},
                              .figures = {{"step", 0.001}}}),
              StartsWith("aliased with K0, Kii at the resolution of the record: the inputs are written in "
                         "steps of 0.001 g"));
  EXPECT_THAT(english_reason({.code = Code::term_hidden_by_uncertainty,
                              .terms = {Term::Koo, Term::K0, Term::Kii},
                              .figures = {{"sigma", 1e-4}}}),
              StartsWith("aliased with K0, Kii at the uncertainty of the inputs: it is 0.0001 g"));
  EXPECT_EQ(english_reason({.code = Code::verbatim, .figures = {{"text", std::string("{old} words")}}}),
            "{old} words");
}

TEST(English, SaysOfFewRowsThatTheirScaleCanHardlyBeChecked) {
  const auto few_rows = [](double spare) {
    return english({.code = Code::scale_doubtful,
                    .severity = Severity::basis,
                    .figures = {{"spare", spare}, {"enough", 30.0}}});
  };
  EXPECT_THAT(few_rows(10.0),
              StartsWith("the robust scale can hardly be checked with 10 rows more than terms: "));
  EXPECT_THAT(few_rows(10.0), HasSubstr("at least 30 rows more than terms"));
  EXPECT_THAT(few_rows(1.0), HasSubstr("with 1 row more than terms"));
}

TEST(English, NamesChoices) {
  EXPECT_THAT(english({.code = Code::student_loss,
                       .figures = {{"tuning", 4.0},
                                   {"origin", std::string("default")},
                                   {"scale", 0.5},
                                   {"unit", std::string("mV")}}}),
              HasSubstr("4 degrees of freedom (by default)"));
  EXPECT_THAT(english({.code = Code::terms_chosen,
                       .terms = {Term::K0},
                       .figures = {{"criterion", std::string("regularity")},
                                   {"rows", 210.0},
                                   {"first", 147.0},
                                   {"second", 63.0},
                                   {"count", 1.0},
                                   {"total", 3.0},
                                   {"value", 0.5},
                                   {"unit", std::string("g")}}}),
              HasSubstr("chosen by regularity on 63 checking rows of 210 ("));
}

// An infinite figure is a word in a result file, and the sentence is the same.
TEST(English, SaysInfinite) {
  Finding finding{.code = Code::layers_short_of_optimum,
                  .figures = {{"ratio", std::numeric_limits<double>::infinity()}}};
  const std::string text = english(finding);
  EXPECT_THAT(text, HasSubstr("is infinite times"));
  finding.figures = {{"ratio", std::string("infinite")}};
  EXPECT_EQ(english(finding), text);
}

}  // namespace
}  // namespace proofmass
