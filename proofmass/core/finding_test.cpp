// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/finding.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace proofmass {
namespace {

bool is_snake_case(std::string_view name) {
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; };
  return !name.empty() && name.front() != '_' && name.back() != '_' &&
         name.find("__") == std::string_view::npos && std::all_of(name.begin(), name.end(), allowed);
}

TEST(Code, EachHasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (const Code code : all_codes()) {
    const std::string_view name = to_string(code);
    EXPECT_TRUE(is_snake_case(name)) << name;
    EXPECT_TRUE(names.insert(name).second) << name << " twice";
    EXPECT_EQ(find_code(name), code) << name;
  }
  EXPECT_EQ(all_codes().front(), Code::verbatim);
  EXPECT_EQ(all_codes().back(), Code::outputs_unlike_plan);
}

// The table of names is apart from the codes: one left out would move all that follow.
TEST(Code, NamesAreThoseOfTheCodes) {
  EXPECT_EQ(to_string(Code::verbatim), "verbatim");
  EXPECT_EQ(to_string(Code::test_error_larger), "test_error_larger");
  EXPECT_EQ(to_string(Code::weighted_noise_assumed), "weighted_noise_assumed");
  EXPECT_EQ(to_string(Code::robust_errors_asymptotic), "robust_errors_asymptotic");
  EXPECT_EQ(to_string(Code::search_errors_added), "search_errors_added");
  EXPECT_EQ(to_string(Code::hidden_choice_ignored), "hidden_choice_ignored");
  EXPECT_EQ(to_string(Code::outputs_unlike_plan), "outputs_unlike_plan");
}

TEST(Code, IsNotFoundByAnotherName) {
  for (const char* name : {"", "Verbatim", "verbatim ", "verb", "a_code_of_a_later_version"}) {
    EXPECT_FALSE(find_code(name).has_value()) << name;
  }
}

TEST(Severity, IsABasisANoteOrAWarning) {
  for (const Severity severity : {Severity::basis, Severity::note, Severity::warning})
    EXPECT_EQ(find_severity(to_string(severity)), severity);
  EXPECT_EQ(find_severity("grave"), std::nullopt);
  EXPECT_EQ(to_string(Severity::basis), "basis");
  EXPECT_EQ(Finding{.code = Code::white_noise_assumed}.severity, Severity::basis);
  EXPECT_EQ(Finding{.code = Code::inputs_collinear}.severity, Severity::note);
  EXPECT_EQ(to_string(Severity::note), "note");
  EXPECT_EQ(to_string(Severity::warning), "warning");
}

TEST(Finding, DiffersByEachOfItsParts) {
  const Finding finding{.code = Code::outlying_rows,
                        .severity = Severity::note,
                        .terms = {Term::Ki},
                        .lines = {7},
                        .figures = {{"count", std::size_t{1}}, {"unit", std::string("g")}}};
  EXPECT_EQ(finding, Finding(finding));
  EXPECT_EQ(std::get<double>(finding.figures[0].value), 1.0);
  Finding other = finding;
  other.code = Code::huber_loss;
  EXPECT_NE(other, finding);
  other = finding;
  other.severity = Severity::warning;
  EXPECT_NE(other, finding);
  other = finding;
  other.terms.push_back(Term::Ko);
  EXPECT_NE(other, finding);
  other = finding;
  other.lines.clear();
  EXPECT_NE(other, finding);
  other = finding;
  other.figures[0].name = "total";
  EXPECT_NE(other, finding);
  other = finding;
  other.figures[1].value = 1.0;
  EXPECT_NE(other, finding);
}

}  // namespace
}  // namespace proofmass
