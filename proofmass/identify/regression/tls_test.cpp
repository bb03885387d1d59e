// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/tls.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/regression/eiv.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "support/errors_in_variables.hpp"
#include "support/findings.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;

IdentifyOptions options_for(const char* terms) { return {.terms = parse_terms(terms)}; }

Identification fitted(const Dataset& record, const IdentifyOptions& options, const Tls& method = {}) {
  SilentProgress progress;
  return fit(method, record, options, progress);
}

// Ai, Ao, Ap over the sphere with input noise as large as leaves least squares far behind.
SimulationPlan shaken(TermList terms, std::vector<double> truth) {
  SimulationPlan plan;
  plan.model = {.terms = std::move(terms), .coefficients = std::move(truth)};
  plan.sphere = SphereInputs{.minimum = 0.0, .maximum = 2.0};
  plan.noise.sigma = 0.05;
  plan.input_sigma = {0.1, 0.1, 0.1};
  plan.record_sigma = true;
  plan.rows = 500;
  return plan;
}

// Where the model is linear in the accelerations its assumptions hold, and those of errors in variables give
// the same estimate.
TEST(Tls, IsErrorsInVariablesWhereTheModelIsLinear) {
  const SimulationPlan plan = shaken(parse_terms("linear"), {0.02, 1.1, -0.2, 0.1});
  const IdentifyOptions options = options_for("linear");
  SilentProgress progress;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Dataset record = simulate(plan, plan.rows, seed);
    const Identification tls = fitted(record, options);
    const Identification eiv = fit(Eiv{}, record, options, progress);
    for (std::size_t k = 0; k < 4; ++k) {
      const double error = *eiv.coefficients[k].standard_error;
      EXPECT_NEAR(tls.coefficients[k].value, eiv.coefficients[k].value, 1e-7 * error) << seed << " " << k;
      EXPECT_NEAR(*tls.coefficients[k].standard_error, error, 0.05 * error);
    }
  }
}

TEST(Tls, ErrorsAreWhatTheStandardErrorsSayWhereTheModelIsLinear) {
  const SimulationPlan plan = shaken(parse_terms("linear"), {0.02, 1.1, -0.2, 0.1});
  const IdentifyOptions options = options_for("linear");
  test::ErrorTally tally(plan, options.terms);
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
    tally.add(fitted(simulate(plan, plan.rows, seed), options));
  EXPECT_NEAR(tally.over_standard_error(), 1.0, 0.08);
  EXPECT_LT(tally.over_bound(), 1.15);
  EXPECT_LT(std::abs(tally.bias_in_standard_errors(Term::Ki)), 3.0);
}

TEST(Tls, SaysThatItIsBiasedForPowersAndIs) {
  const SimulationPlan plan = shaken(parse_terms("K0,Ki,Kii,Kiii"), {0.02, 1.1, 0.1, 0.05});
  const IdentifyOptions options = options_for("K0,Ki,Kii,Kiii");
  test::ErrorTally tls(plan, options.terms);
  test::ErrorTally eiv(plan, options.terms);
  SilentProgress progress;
  Identification last;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Dataset record = simulate(plan, plan.rows, seed);
    tls.add(last = fitted(record, options));
    eiv.add(fit(Eiv{}, record, options, progress));
  }
  EXPECT_GT(std::abs(tls.bias_in_standard_errors(Term::Kiii)), 10.0);
  EXPECT_GT(tls.over_bound(), 1.5 * eiv.over_bound());
  EXPECT_EQ(test::finding_of(last, Code::total_least_squares_biased).severity, Severity::warning);
}

TEST(Tls, RefusesWithoutUncertaintiesSayingWhatToGive) {
  try {
    (void)fitted(test::make_twin(), options_for("linear"));
    ADD_FAILURE() << "no refusal";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), HasSubstr("tls needs the uncertainty of the output"));
    ASSERT_FALSE(error.remedies().empty());
    EXPECT_EQ(error.remedies().front().option, "sigma-output-ug");
  }
}

TEST(Tls, RefusesWhereTheUncertaintiesSwallowTheInputs) {
  Dataset record = test::make_twin({.rows = 60, .least = 0.0, .greatest = 1e-3});
  // An input that has nothing to do with the output, and is said to be very uncertain.
  RandomStream random(5);
  for (double& value : record.output) value = random.normal();
  try {
    (void)fitted(record, options_for("linear"), {.uncertainty = {.input = 1.0, .output = 1e-6}});
    ADD_FAILURE() << "no refusal";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), HasSubstr("no generic solution"));
  }
}

}  // namespace
}  // namespace proofmass
