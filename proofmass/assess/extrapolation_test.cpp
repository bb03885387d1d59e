// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/extrapolation.hpp"

#include <gtest/gtest.h>

#include <variant>

namespace proofmass {
namespace {

Dataset inputs() {
  Dataset data;
  data.acceleration[0] = {0.0, 1.0, 2.1, -2.0};
  data.acceleration[1] = {0.0, 5.1, 0.0, 0.0};
  data.line = {2, 3, 5, 8};
  return data;
}

Identification of_terms(const TermList& terms) {
  Identification result;
  for (const Term term : terms) {
    result.coefficients.emplace_back();
    result.coefficients.back().term = term;
  }
  return result;
}

double figure(const Finding& finding, std::string_view name) {
  for (const Figure& one : finding.figures) {
    if (one.name == name) return std::get<double>(one.value);
  }
  return -1.0;
}

TEST(Extrapolation, CountsRowsOutsideTheRangeOfSomeAxis) {
  Identification result = of_terms({Term::Ki, Term::Koo});
  result.input_range = {{Axis::input, {-2.0, 2.0}}, {Axis::output, {-5.0, 5.0}}};
  const auto found = find_extrapolation(result, inputs());
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->severity, Severity::warning);
  EXPECT_EQ(figure(*found, "count"), 2.0);
  EXPECT_EQ(figure(*found, "total"), 4.0);
  EXPECT_EQ(figure(*found, "line"), 3.0);
}

TEST(Extrapolation, IsSilentWithinTheRangeAndWithoutOne) {
  Identification result = of_terms({Term::Ki, Term::Kp});
  EXPECT_FALSE(find_extrapolation(result, inputs()).has_value());
  result.input_range = {{Axis::input, {-2.0, 2.1}}, {Axis::pendulous, {0.0, 0.0}}};
  EXPECT_FALSE(find_extrapolation(result, inputs()).has_value()) << "the ends belong to it; Ap is not given";
}

TEST(Extrapolation, HeedsOnlyAxesThatTheModelUses) {
  Identification result = of_terms({Term::K0, Term::Ki});
  result.input_range = {{Axis::input, {-2.0, 2.1}}, {Axis::output, {-5.0, 5.0}}};
  EXPECT_FALSE(find_extrapolation(result, inputs()).has_value());
}

TEST(Extrapolation, TakesANetworksRangeWhereTheResultKnowsNoOther) {
  Identification result;
  result.network = TrainedNetwork{
      .inputs = {Axis::input}, .hidden = 0, .weights = {}, .input_range = {{0.0, 2.0}}, .output_range = {}};
  const auto found = find_extrapolation(result, inputs());
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(figure(*found, "line"), 5.0);
}

}  // namespace
}  // namespace proofmass
