// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/search/gmdh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/regression/ols.hpp"
#include "support/endings.hpp"
#include "support/findings.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;

Identification fitted(const Dataset& record, const char* terms, const Gmdh& method = {}) {
  SilentProgress progress;
  return fit(method, record, {.terms = parse_terms(terms)}, progress);
}

void expect_error(const Dataset& record, const char* terms, const Gmdh& method, ErrorKind kind,
                  const char* text) {
  try {
    (void)fitted(record, terms, method);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    EXPECT_THAT(error.what(), HasSubstr(text));
  }
}

TEST(GmdhCombi, WithoutNoiseExactlyTheTrueTerms) {
  for (const char* terms : {"K0,Ki,Kii,Kip,Koq", "linear", "paper", "Ki,Kop,Kiop,Kppp"}) {
    StaticModel truth{.terms = parse_terms(terms), .coefficients = {}};
    for (std::size_t k = 0; k < truth.terms.size(); ++k)
      truth.coefficients.push_back(truth.terms[k] == Term::Ki ? 0.99 : 1e-6 * static_cast<double>(k + 1));
    for (const auto criterion :
         {GmdhCriterion::press, GmdhCriterion::regularity, GmdhCriterion::unbiasedness}) {
      const Identification result =
          fitted(test::make_twin({.noise = 0.0}, truth), "full", {.criterion = criterion});
      EXPECT_EQ(result.static_model().terms, truth.terms) << terms;
      for (const Term term : truth.terms)
        EXPECT_NEAR(result.static_model().coefficient(term), truth.coefficient(term), 1e-13);
    }
  }
}

// By PRESS a superfluous term stays when its t² exceeds 2, with a probability of 0.16.
TEST(GmdhCombi, TrueTermsAllAndFalseOnesFew) {
  const StaticModel truth = test::paper_truth();
  constexpr std::uint64_t seeds = 20;
  std::size_t false_terms = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Dataset record = test::make_twin({.rows = 1400, .noise = 1e-5, .seed = seed});
    const Identification result = fitted(record, "full");
    EXPECT_EQ(result.ending.status, EndingStatus::converged) << test::said(result.ending);
    for (const Coefficient& c : result.coefficients) {
      const bool real = truth.coefficient(c.term) != 0.0;
      EXPECT_TRUE(c.identified || !real) << name(c.term) << " seed " << seed;
      if (!real && c.identified) ++false_terms;
    }
  }
  const double rate = static_cast<double>(false_terms) / (6.0 * seeds);
  EXPECT_LT(rate, 0.25);
  RecordProperty("false_term_rate", std::to_string(rate));
}

TEST(GmdhCombi, IsLeastSquaresOnTheTermsItChose) {
  const Dataset record = test::make_twin();
  const Identification result = fitted(record, "full");
  const StaticModel model = result.static_model();
  EXPECT_LT(model.terms.size(), 21U);
  SilentProgress progress;
  const Identification ols = fit(Ols{}, record, {.terms = model.terms}, progress);
  EXPECT_EQ(model.coefficients, ols.static_model().coefficients);
  EXPECT_EQ(result.covariance, ols.covariance);
  EXPECT_EQ(result.diagnostics.residual_sd, ols.diagnostics.residual_sd);
  EXPECT_TRUE(test::has(result, Code::choice_taken_as_given));
  for (const Coefficient& c : result.coefficients) {
    EXPECT_EQ(c.identified, model.coefficient(c.term) != 0.0);
    EXPECT_EQ(c.reason.has_value(), !c.identified);
    EXPECT_TRUE(c.identified || c.reason->code == Code::term_left_out);
  }
  ASSERT_EQ(result.history.size(), 1U);
  EXPECT_EQ(result.history[0].values.size(), 21U);
}

TEST(GmdhCombi, SaysWhenTheSearchWasNotExhaustive) {
  const Identification result =
      fitted(test::make_twin(), "full", {.criterion = GmdhCriterion::unbiasedness, .models = 50});
  EXPECT_EQ(result.ending.status, EndingStatus::iteration_limit);
  EXPECT_THAT(test::said(result.ending), HasSubstr("not exhaustive"));
}

TEST(Gmdh, RefusesPartsThatCannotServe) {
  const Dataset record = test::make_twin({.rows = 30});
  expect_error(record, "paper", {.criterion = GmdhCriterion::unbiasedness}, ErrorKind::bad_data,
               "at least 16 in each part");
  expect_error(record, "paper", {.criterion = GmdhCriterion::regularity, .checking_fraction = 1.0},
               ErrorKind::usage, "gmdh-checking-fraction");
  Dataset lopsided = test::make_twin({.rows = 60});
  for (std::size_t r = 1; r < 60; ++r) lopsided.acceleration[1][r] = 0.0;
  expect_error(lopsided, "linear", {.criterion = GmdhCriterion::unbiasedness}, ErrorKind::refused,
               "criterion press needs no such division");
  expect_error(record, "K0,Ki,Kii", {.form = GmdhForm::mia}, ErrorKind::refused, "form combi");
}

// Each axis is seen in one row alone, whose leverage is then 1.
Dataset axes_seen_once() {
  Dataset record;
  record.source = "four";
  record.acceleration = {
      std::vector<double>{1.0, 0.0, 0.0, 0.0, 0.0}, {0.0, 1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0, 0.0}};
  record.output = {1.00012, 0.00031, -0.00012, 0.00002, 0.00001};
  return record;
}

TEST(Gmdh, RefusesTermsThatOneRowAloneIdentifies) {
  for (const char* terms : {"Ki,Ko,Kp", "Ki", "K0,Ki,Ko,Kp"}) {
    expect_error(axes_seen_once(), terms, {}, ErrorKind::refused, "one row alone identifies");
  }
  expect_error(axes_seen_once(), "K0,Ki,Ko,Kp", {.form = GmdhForm::mia}, ErrorKind::refused, "form combi");
}

TEST(GmdhCombi, DoesNotSilentlyLeaveOutWhatItCannotJudge) {
  Dataset record = test::make_twin();
  record.acceleration[1].assign(record.rows(), 0.0);
  record.acceleration[1][7] = 5.0;
  expect_error(record, "K0,Ki,Ko", {}, ErrorKind::refused, "one row alone identifies");
  EXPECT_TRUE(fitted(record, "K0,Ki").coefficients[1].identified);
}

// Products of two axes and squares are what one neuron can do, so a truth of these must come out exactly.
TEST(GmdhMia, ExpandsToTheTruthWhereNeuronsCanHoldIt) {
  const StaticModel truth{.terms = {Term::K0, Term::Ki, Term::Kii, Term::Kio, Term::Ko, Term::Koo},
                          .coefficients = {1e-5, 0.99, 2e-5, 3e-5, -4e-5, 5e-6}};
  const Identification result =
      fitted(test::make_twin({.noise = 0.0}, truth), "full", {.form = GmdhForm::mia});
  for (const Coefficient& c : result.coefficients)
    EXPECT_NEAR(c.value, truth.coefficient(c.term), 1e-12) << name(c.term);
}

TEST(GmdhMia, SeesTheOddQuadraticTermAsAnInput) {
  const StaticModel truth{.terms = {Term::K0, Term::Ki, Term::Koq}, .coefficients = {1e-5, 0.99, 7e-5}};
  const Identification result =
      fitted(test::make_twin({.noise = 0.0}, truth), "full", {.form = GmdhForm::mia});
  EXPECT_NEAR(result.static_model().coefficient(Term::Koq), 7e-5, 1e-12);
  EXPECT_NEAR(result.static_model().coefficient(Term::Kii), 0.0, 1e-12);
}

TEST(GmdhMia, ReportsWhatFallsOutsideAndClaimsNoStandardErrors) {
  const Identification result = fitted(test::make_twin(), "full", {.form = GmdhForm::mia});
  EXPECT_TRUE(test::has(result, Code::layers_beyond_terms));
  EXPECT_FALSE(result.coefficients[1].standard_error.has_value());
  EXPECT_TRUE(result.covariance.empty());
  EXPECT_NEAR(result.coefficients[1].value, 0.999979, 1e-2);
  ASSERT_EQ(result.history.size(), 1U);
  EXPECT_EQ(result.history[0].name, "criterion_by_layer");
  EXPECT_FALSE(test::said(result.ending).empty());
}

}  // namespace
}  // namespace proofmass
