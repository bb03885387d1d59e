// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/wls.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/regression/ols.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "support/efficiency.hpp"
#include "support/findings.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;

Identification fitted(const Dataset& record, const Wls& method = {}, const char* terms = "linear",
                      RankLossPolicy policy = RankLossPolicy::refuse) {
  SilentProgress progress;
  return fit(method, record, {.terms = parse_terms(terms), .on_rank_loss = policy}, progress);
}

// Required: within 1.15 of the efficient bound. Twenty seeds and 15 correlated terms tell the figure to about
// 0.03 (one standard deviation); over 200 seeds it is 1.00 for wls and 1.32 for ols.
TEST(Wls, ReachesTheBoundWhereNoiseGrowsWithAcceleration) {
  const SimulationPlan plan = test::shipped_plan("twin-heteroscedastic");
  const IdentifyOptions options{.terms = parse_terms("paper")};
  const test::Efficiency weighted = test::measure_efficiency(Wls{}, plan, options, 20);
  EXPECT_LT(weighted.over_bound, 1.15);
  EXPECT_GT(weighted.over_bound, 0.88);  // nothing beats the bound by more than chance
  EXPECT_NEAR(weighted.over_stated, 1.0, 0.1);
  EXPECT_GT(test::measure_efficiency(Ols{}, plan, options, 20).over_bound, 1.25);
}

TEST(Wls, StatesTheVarianceModelItFound) {
  const Identification result =
      fitted(simulate(test::shipped_plan("twin-heteroscedastic"), 2000, 3), {}, "paper");
  EXPECT_EQ(result.ending.status, EndingStatus::converged);
  const Finding& model = test::finding_of(result, Code::weights_from_model);
  EXPECT_GE(test::number(model, "s0"), 0.0);
  EXPECT_GT(test::number(model, "s1"), 0.0);
  EXPECT_EQ(test::word(model, "axes"), "Ai, Ao, Ap");
}

TEST(Wls, GivenSigmasSetTheStandardErrors) {
  Dataset record =
      test::make_twin({.noise = 1e-4}, {.terms = {Term::K0, Term::Ki}, .coefficients = {0.0, 1.0}});
  record.output_sigma.assign(record.rows(), 2e-4);  // twice the truth
  SilentProgress progress;
  const Identification plain = fit(Ols{}, record, {.terms = parse_terms("linear")}, progress);
  const Identification given = fitted(record);
  const Identification scaled = fitted(record, {.scaling = ChiSquareScaling::scaled});
  for (std::size_t k = 0; k < 4; ++k) {
    const double expected = *plain.coefficients[k].standard_error;
    EXPECT_NEAR(given.coefficients[k].value, plain.coefficients[k].value, 1e-3 * expected);
    EXPECT_NEAR(*scaled.coefficients[k].standard_error, expected, 1e-9 * expected);
    EXPECT_NEAR(*given.coefficients[k].standard_error, expected * 2e-4 / *plain.diagnostics.residual_sd,
                1e-9 * expected);
  }
  EXPECT_TRUE(test::has(given, Code::weights_from_sigma));
  EXPECT_TRUE(test::has(fitted(record, {.weights = WeightSource::model}), Code::sigma_output_unused));
}

TEST(Wls, RowsOfLargeSigmaCountLittle) {
  Dataset record =
      test::make_twin({.noise = 0.0}, {.terms = {Term::K0, Term::Ki}, .coefficients = {0.0, 1.0}});
  record.output_sigma.assign(record.rows(), 1e-6);
  record.output[7] += 1.0;
  record.output_sigma[7] = 1e3;
  EXPECT_NEAR(fitted(record).coefficients[1].value, 1.0, 1e-12);
}

TEST(Wls, ManyRowsGiveTheSameBitsOnAnyThreads) {
  Dataset record = test::make_twin({.rows = 20'000});
  const auto with_threads = [&record](std::size_t threads, WeightSource source) {
    const ThreadLimit limit(threads);
    return fitted(record, {.weights = source}, "quadratic");
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
  const auto message = [](const Dataset& data, const Wls& method) -> std::string {
    try {
      (void)fitted(data, method);
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
  EXPECT_THROW((void)fitted(record), Error);
  const Identification result = fitted(record, {}, "linear", RankLossPolicy::drop);
  EXPECT_FALSE(result.coefficients[3].identified);
  const Finding expected{
      .code = Code::term_input_zero,
      .terms = {Term::Kp},
      .figures = {{"product", std::string("Ap")}, {"count", std::size_t{270}}, {"total", std::size_t{300}}}};
  EXPECT_EQ(result.coefficients[3].reason, expected);
  EXPECT_NEAR(result.coefficients[1].value, 0.9, 1e-4);
}

// Rows whose sigma is 1e9 times that of the others tell nothing, of the errors neither.
TEST(Wls, DegreesOfFreedomCountRowsWithWeightOnly) {
  Dataset record = test::make_twin({}, {.terms = {Term::K0, Term::Ki}, .coefficients = {1e-3, 0.9}});
  const auto with_weight = [&record](std::size_t rows) {
    record.output_sigma.assign(record.rows(), 1e5);
    std::fill_n(record.output_sigma.begin(), rows, 1e-4);
    return fitted(record, {}, "linear", RankLossPolicy::drop);
  };
  const Identification result = with_weight(20);
  EXPECT_EQ(result.diagnostics.dof, 16U);
  const Finding& weightless = test::finding_of(result, Code::rows_without_weight);
  EXPECT_EQ(test::number(weightless, "count"), 280.0);
  EXPECT_EQ(test::number(weightless, "total"), 300.0);
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
