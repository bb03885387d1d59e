// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/deviations.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace proofmass {
namespace {

using ::testing::ElementsAre;

Contestant contestant_of(std::string method, double ki, std::optional<double> error) {
  Contestant made;
  made.method = std::move(method);
  Coefficient c;
  c.term = Term::Ki;
  c.value = ki;
  c.standard_error = error;
  made.runs.resize(1);
  made.runs.front().identification.coefficients = {c};
  return made;
}

TEST(Deviations, AreFromTheTruthInEachMethodsOwnErrors) {
  Comparison comparison;
  comparison.contestants = {contestant_of("a", 1.03, 0.01), contestant_of("b", 1.03, std::nullopt)};
  comparison.truth = StaticModel{.terms = {Term::Ki}, .coefficients = {1.0}};
  const Deviations made = deviations(comparison);
  EXPECT_TRUE(made.from_truth);
  EXPECT_THAT(made.methods, ElementsAre("a", "b"));
  EXPECT_NEAR(made.in_errors[0][0], 3.0, 1e-9);
  EXPECT_TRUE(std::isnan(made.in_errors[1][0]));
}

TEST(Deviations, AreFromTheFirstMethodWithErrorsWhereTheTruthIsNotKnown) {
  Comparison comparison;
  comparison.contestants = {contestant_of("a", 1.0, std::nullopt), contestant_of("b", 2.0, 0.1),
                            contestant_of("c", 1.9, 0.3)};
  const Deviations made = deviations(comparison);
  EXPECT_EQ(made.reference, "b");
  EXPECT_THAT(made.methods, ElementsAre("a", "c"));
  EXPECT_NEAR(made.in_errors[0][0], -10.0, 1e-9);
  EXPECT_NEAR(made.in_errors[1][0], -1.0, 1e-9);
}

TEST(FiveNumbers, AreTukeysAndNameWhatLiesBeyond) {
  const FiveNumbers made = five_numbers({5.0, 1.0, 2.0, 3.0, 4.0, 100.0, 6.0});
  EXPECT_EQ(made.median, 4.0);
  EXPECT_EQ(made.lower, 2.5);
  EXPECT_EQ(made.upper, 5.5);
  EXPECT_EQ(made.low, 1.0);
  EXPECT_EQ(made.high, 6.0);
  EXPECT_THAT(made.beyond, ElementsAre(100.0));
  EXPECT_EQ(five_numbers({7.0}).upper, 7.0);
}

}  // namespace
}  // namespace proofmass
