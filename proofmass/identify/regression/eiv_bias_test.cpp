// SPDX-License-Identifier: Apache-2.0
// Errors in variables against the truth, and least squares beside it.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "proofmass/identify/regression/eiv.hpp"
#include "proofmass/identify/regression/ols.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "support/efficiency.hpp"
#include "support/errors_in_variables.hpp"

namespace proofmass {
namespace {

struct Tallies {
  test::ErrorTally eiv, ols;
};

// 200 records of the twin with noise of `input_sigma` g on every axis.
Tallies tally(double input_sigma) {
  SimulationPlan plan = test::shipped_plan("twin-input-noise");
  plan.input_sigma.fill(input_sigma);
  IdentifyOptions options;
  options.terms = parse_terms("paper");
  constexpr std::size_t repeats = 200;
  std::vector<Identification> results(2 * repeats);
  parallel_for(repeats, [&](std::size_t k) {
    SilentProgress progress;
    const Dataset record = simulate(plan, plan.rows, k + 1);
    results[2 * k] = fit(Eiv{}, record, options, progress);
    results[2 * k + 1] = fit(Ols{}, record, options, progress);
  });
  Tallies tallies{test::ErrorTally(plan, options.terms), test::ErrorTally(plan, options.terms)};
  for (std::size_t k = 0; k < results.size(); ++k) {
    (k % 2 == 0 ? tallies.eiv : tallies.ols).add(results[k]);
  }
  return tallies;
}

void record_bias(Term term, const Tallies& tallies) {
  const auto record = [term](const char* method, const test::ErrorTally& errors) {
    testing::Test::RecordProperty(std::string(name(term)) + "_bias_" + method,
                                  std::to_string(errors.bias_in_standard_errors(term)));
  };
  record("eiv", tallies.eiv);
  record("ols", tallies.ols);
}

// As shipped: 0.1 g.
TEST(EivBias, UnbiasedAndEfficientWhereLeastSquaresIsNot) {
  const Tallies tallies = tally(0.1);
  for (const Term term : {Term::Kii, Term::Kiii}) {
    record_bias(term, tallies);
    EXPECT_LT(std::abs(tallies.eiv.bias_in_standard_errors(term)), 2.0) << name(term);
    EXPECT_GT(std::abs(tallies.ols.bias_in_standard_errors(term)), 10.0) << name(term);
  }
  RecordProperty("over_bound_eiv", std::to_string(tallies.eiv.over_bound()));
  RecordProperty("over_bound_ols", std::to_string(tallies.ols.over_bound()));
  EXPECT_LT(tallies.eiv.over_bound(), 1.15);
  EXPECT_GT(tallies.ols.over_bound(), 1.15);
  EXPECT_NEAR(tallies.eiv.over_standard_error(), 1.0, 0.05);
}

// At 200 µg the bias of least squares is far below what 200 repeats can see: the two agree.
TEST(EivBias, UnbiasedAndEfficientWhereLeastSquaresIsToo) {
  const Tallies tallies = tally(2e-4);
  for (const Term term : {Term::Kii, Term::Kiii}) {
    record_bias(term, tallies);
    EXPECT_LT(std::abs(tallies.eiv.bias_in_standard_errors(term)), 2.0) << name(term);
    EXPECT_NEAR(tallies.eiv.bias_in_standard_errors(term), tallies.ols.bias_in_standard_errors(term), 0.5)
        << name(term);
  }
  EXPECT_LT(tallies.eiv.over_bound(), 1.15);
  EXPECT_LT(tallies.ols.over_bound(), 1.15);
}

}  // namespace
}  // namespace proofmass
