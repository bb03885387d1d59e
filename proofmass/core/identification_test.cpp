// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/identification.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

Coefficient estimate(Term term, double value, double error) {
  Coefficient c;
  c.term = term;
  c.value = value;
  c.standard_error = error;
  c.ci95 = Interval{.low = value - 2.5 * error, .high = value + 2.5 * error};
  return c;
}

// Three correlated identified coefficients of an output in mA, and an unidentified one between them.
Identification in_milliamperes() {
  Identification result;
  result.coefficients = {estimate(Term::K0, 0.004, 0.01), estimate(Term::Ki, -1.25, 0.02),
                         estimate(Term::Kii, 7.0, 0.0), estimate(Term::Ko, 0.5, 0.03)};
  result.coefficients[2].identified = false;
  result.coefficients[2].reason = {.code = Code::term_aliased, .terms = {Term::Kii, Term::K0}};
  result.covariance = {1e-4,  5e-5, -1e-4,  //
                       5e-5,  4e-4, 3e-4,   //
                       -1e-4, 3e-4, 9e-4};
  return result;
}

TEST(Identification, StaticModelHoldsWhatWasIdentified) {
  const StaticModel model = in_milliamperes().static_model();
  EXPECT_EQ(model.terms, (TermList{Term::K0, Term::Ki, Term::Ko}));
  EXPECT_EQ(model.coefficients, (std::vector{0.004, -1.25, 0.5}));
}

TEST(Identification, FindsTheCoefficientOfATerm) {
  const Identification result = in_milliamperes();
  for (const Coefficient& c : result.coefficients) EXPECT_EQ(&result.find(c.term), &c) << name(c.term);
  EXPECT_EQ(result.find(Term::Ki).value, -1.25);
  EXPECT_FALSE(result.find(Term::Kii).identified) << "asked for, though not identified";
}

TEST(Identification, HasNoCoefficientOfATermThatWasNotAskedFor) {
  try {
    (void)in_milliamperes().find(Term::Kop);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_NE(std::string(error.what()).find("Kop"), std::string::npos) << error.what();
  }
}

// Propagates the covariance through x/Ki by central differences, as an independent check.
double propagated_error(const Identification& result, std::size_t index) {
  constexpr double step = 1e-6;
  const auto values = result.static_model().coefficients;
  std::array<double, 3> slope{};
  for (std::size_t k = 0; k < 3; ++k) {
    auto up = values;
    auto down = values;
    up[k] += step;
    down[k] -= step;
    slope[k] = (up[index] / up[1] - down[index] / down[1]) / (2 * step);
  }
  double variance = 0.0;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) variance += slope[r] * result.covariance[r * 3 + c] * slope[c];
  }
  return std::sqrt(variance);
}

TEST(ReferredToInput, DividesByKiWithErrorsByTheDeltaMethod) {
  const Identification result = in_milliamperes();
  const auto referred = referred_to_input(result);
  ASSERT_EQ(referred.size(), 4U);
  const std::pair<std::size_t, std::size_t> identified[] = {{0, 0},
                                                            {3, 2}};  // in the list, in the covariance
  for (const auto& [at, index] : identified) {
    const Coefficient& c = referred[at];
    EXPECT_DOUBLE_EQ(c.value, result.coefficients[at].value / -1.25);
    ASSERT_TRUE(c.standard_error);
    const double error = propagated_error(result, index);
    EXPECT_NEAR(*c.standard_error, error, 1e-8 * error);
    EXPECT_NEAR(c.ci95->high - c.value, 2.5 * error, 1e-7 * error);
    EXPECT_NEAR(c.value - c.ci95->low, 2.5 * error, 1e-7 * error);
    EXPECT_NEAR(*c.t, c.value / error, 1e-7 * std::abs(c.value / error));
  }
}

TEST(ReferredToInput, KiIsOneByDefinition) {
  const Coefficient ki = referred_to_input(in_milliamperes())[1];
  EXPECT_EQ(ki.value, 1.0);
  EXPECT_FALSE(ki.standard_error);
  EXPECT_FALSE(ki.ci95);
}

TEST(ReferredToInput, KeepsWhyATermIsNotIdentified) {
  const Coefficient kii = referred_to_input(in_milliamperes())[2];
  EXPECT_FALSE(kii.identified);
  EXPECT_EQ(kii.reason, (Finding{.code = Code::term_aliased, .terms = {Term::Kii, Term::K0}}));
}

TEST(ReferredToInput, GivesNoErrorsWithoutACovariance) {
  Identification result = in_milliamperes();
  result.covariance.clear();
  const auto referred = referred_to_input(result);
  EXPECT_DOUBLE_EQ(referred[3].value, -0.4);
  EXPECT_FALSE(referred[3].standard_error);
}

TEST(ReferredToInput, IsEmptyWithoutAScaleFactor) {
  Identification result = in_milliamperes();
  result.coefficients[1].value = 0.0;
  EXPECT_TRUE(referred_to_input(result).empty());
  result = in_milliamperes();
  result.coefficients[1].identified = false;
  EXPECT_TRUE(referred_to_input(result).empty());
}

}  // namespace
}  // namespace proofmass
