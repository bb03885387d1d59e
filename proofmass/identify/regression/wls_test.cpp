// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/wls.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/regression/ols.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "support/efficiency.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::Contains;
using testing::HasSubstr;

Identification fit(const Dataset& record, const WlsOptions& wls = {}, const char* terms = "linear",
                   RankLossPolicy policy = RankLossPolicy::refuse) {
  IdentifyOptions options;
  options.terms = parse_terms(terms);
  options.on_rank_loss = policy;
  options.wls = wls;
  SilentProgress progress;
  return identify_wls(record, {}, options, progress);
}

// Required: within 1.15 of the efficient bound. Twenty seeds and 15 correlated terms tell the figure to about
// 0.03 (one standard deviation); over 200 seeds it is 1.00 for wls and 1.32 for ols.
TEST(Wls, ReachesTheBoundWhereNoiseGrowsWithAcceleration) {
  const SimulationPlan plan = test::shipped_plan("twin-heteroscedastic");
  IdentifyOptions options;
  options.terms = parse_terms("paper");
  const test::Efficiency weighted = test::measure_efficiency("wls", plan, options, 20);
  EXPECT_LT(weighted.over_bound, 1.15);
  EXPECT_GT(weighted.over_bound, 0.88);  // nothing beats the bound by more than chance
  EXPECT_NEAR(weighted.over_stated, 1.0, 0.1);
  EXPECT_GT(test::measure_efficiency("ols", plan, options, 20).over_bound, 1.25);
}

TEST(Wls, StatesTheVarianceModelItFound) {
  const Identification result =
      fit(simulate(test::shipped_plan("twin-heteroscedastic"), 2000, 3), {}, "paper");
  EXPECT_EQ(result.ending.status, EndingStatus::converged);
  EXPECT_THAT(result.diagnostics.notes, Contains(HasSubstr("s0² + s1² |A|²")));
  EXPECT_THAT(result.diagnostics.notes, Contains(HasSubstr("|A| over Ai, Ao, Ap")));
}

TEST(Wls, GivenSigmasSetTheStandardErrors) {
  Dataset record =
      test::make_twin({.noise = 1e-4}, {.terms = {Term::K0, Term::Ki}, .coefficients = {0.0, 1.0}});
  record.output_sigma.assign(record.rows(), 2e-4);  // twice the truth
  SilentProgress progress;
  IdentifyOptions options;
  options.terms = parse_terms("linear");
  const Identification plain = identify_ols(record, {}, options, progress);
  const Identification given = fit(record);
  const Identification scaled = fit(record, {.scaling = ChiSquareScaling::scaled});
  for (std::size_t k = 0; k < 4; ++k) {
    const double expected = *plain.coefficients[k].standard_error;
    EXPECT_NEAR(given.coefficients[k].value, plain.coefficients[k].value, 1e-3 * expected);
    EXPECT_NEAR(*scaled.coefficients[k].standard_error, expected, 1e-9 * expected);
    EXPECT_NEAR(*given.coefficients[k].standard_error, expected * 2e-4 / *plain.diagnostics.residual_sd,
                1e-9 * expected);
  }
  EXPECT_THAT(given.diagnostics.notes, Contains(HasSubstr("1 / sigma_E²")));
  EXPECT_THAT(given.diagnostics.notes, Contains(HasSubstr("it is too large")));
  EXPECT_THAT(fit(record, {.weights = WeightSource::model}).diagnostics.notes,
              Contains(HasSubstr("sigma_E is not used")));
}

TEST(Wls, RowsOfLargeSigmaCountLittle) {
  Dataset record =
      test::make_twin({.noise = 0.0}, {.terms = {Term::K0, Term::Ki}, .coefficients = {0.0, 1.0}});
  record.output_sigma.assign(record.rows(), 1e-6);
  record.output[7] += 1.0;
  record.output_sigma[7] = 1e3;
  EXPECT_NEAR(fit(record).coefficients[1].value, 1.0, 1e-12);
}

TEST(Wls, ManyRowsGiveTheSameBitsOnAnyThreads) {
  Dataset record = test::make_twin({.rows = 20'000});
  const auto with_threads = [&record](std::size_t threads, WeightSource source) {
    const ThreadLimit limit(threads);
    return fit(record, {.weights = source}, "quadratic");
  };
  for (std::size_t row = 0; row < record.rows(); ++row)
    record.output_sigma.push_back(row % 3 == 0 ? 2e-4 : 4e-4);
  for (const WeightSource source : {WeightSource::sigma, WeightSource::model}) {
    const Identification once = with_threads(1, source);
    const Identification again = with_threads(2, source);
    for (std::size_t k = 0; k < once.coefficients.size(); ++k) {
      EXPECT_EQ(once.coefficients[k].value, again.coefficients[k].value);
    }
    EXPECT_EQ(once.covariance, again.covariance);
    EXPECT_EQ(once.diagnostics.residual_sd, again.diagnostics.residual_sd);
  }
}

TEST(Wls, RefusesMissingAndWrongSigmas) {
  Dataset record = test::make_twin();
  const auto message = [](const Dataset& data, const WlsOptions& options) -> std::string {
    try {
      (void)fit(data, options);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_data);
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message(record, {.weights = WeightSource::sigma}), HasSubstr("sigma_E"));
  record.output_sigma.assign(record.rows(), 3e-4);
  record.output_sigma[4] = 0.0;
  record.line.resize(record.rows());
  record.line[4] = 17;
  EXPECT_THAT(message(record, {}), HasSubstr(":17: column 'sigma_E'"));
}

// Kp is known from rows alone whose sigma is 1e9 times that of the others.
TEST(Wls, RankLossCountsRowsWithWeightOnly) {
  Dataset record = test::make_twin({}, {.terms = {Term::K0, Term::Ki}, .coefficients = {1e-3, 0.9}});
  record.output_sigma.assign(record.rows(), 1e-4);
  for (std::size_t row = 0; row < record.rows(); ++row) {
    if (row % 10 == 0) {
      record.output_sigma[row] = 1e5;
    } else {
      record.acceleration[2][row] = 0.0;
    }
  }
  EXPECT_THROW((void)fit(record), Error);
  const Identification result = fit(record, {}, "linear", RankLossPolicy::drop);
  EXPECT_FALSE(result.coefficients[3].identified);
  EXPECT_THAT(result.coefficients[3].reason, HasSubstr("270 of 300 rows that have weight"));
  EXPECT_NEAR(result.coefficients[1].value, 0.9, 1e-4);
}

// Rows whose sigma is 1e9 times that of the others tell nothing, of the errors neither.
TEST(Wls, DegreesOfFreedomCountRowsWithWeightOnly) {
  Dataset record = test::make_twin({}, {.terms = {Term::K0, Term::Ki}, .coefficients = {1e-3, 0.9}});
  const auto with_weight = [&record](std::size_t rows) {
    record.output_sigma.assign(record.rows(), 1e5);
    std::fill_n(record.output_sigma.begin(), rows, 1e-4);
    return fit(record, {}, "linear", RankLossPolicy::drop);
  };
  const Identification result = with_weight(20);
  EXPECT_EQ(result.diagnostics.dof, 16U);
  EXPECT_THAT(result.diagnostics.notes, Contains(HasSubstr("280 of 300 rows have no weight")));
  EXPECT_EQ(with_weight(5).diagnostics.dof, 1U);
  try {
    (void)with_weight(4);
    ADD_FAILURE() << "no refusal";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), HasSubstr("4 of 300 rows have weight"));
  }
}

}  // namespace
}  // namespace proofmass
