// SPDX-License-Identifier: Apache-2.0
// What every method of identification must obey, whatever it does inside.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "proofmass/assess/metrics.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/split.hpp"
#include "support/method_forms.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using test::Form;
using testing::HasSubstr;

// Small networks and swarms: the laws hold for poor fits as for good ones. The epochs must suffice for a
// network to converge, or what a law allows to vary in the last bit decides how far training has come.
Method small(const Form& form) {
  Method method = form.method;
  test::make_small(method);
  return method;
}

// Uncertainties that grow with the first input by a factor of five, in the output's unit.
Dataset with_sigma(Dataset record) {
  const auto [least, largest] = std::minmax_element(record.output.begin(), record.output.end());
  for (std::size_t row = 0; row < record.rows(); ++row) {
    record.output_sigma.push_back(1e-5 * (*largest - *least) * (1.0 + 0.2 * std::abs(record.at(row).i)));
  }
  return record;
}

Identification fitted(const Form& form, const Dataset& record,
                      const IdentifyOptions& options = {.terms = paper_terms()}) {
  SilentProgress progress;
  return fit(small(form), form.with_sigma ? with_sigma(record) : record, {}, options, progress);
}

Dataset shuffled(const Dataset& record) {
  RandomStream random(7);
  return record.select(random_permutation(record.rows(), random));
}

// The record as a reader makes it of the same figures written in another unit of acceleration.
Dataset rewritten(Dataset record, const Unit& unit) {
  const auto rewrite = [&unit](std::vector<double>& column) {
    for (double& value : column) value = value / unit.to_canonical * unit.to_canonical;
  };
  for (auto& column : record.acceleration) rewrite(column);
  rewrite(record.output);
  record.acceleration_unit = record.output_unit = unit;
  return record;
}

// `other`'s coefficients times `factor` must be `reference`'s: to 1e-10 where the method is exact, otherwise
// to a fraction of the standard error.
void expect_same_coefficients(const Form& form, const Identification& reference, const Identification& other,
                              double factor, double fraction) {
  ASSERT_EQ(reference.coefficients.size(), other.coefficients.size());
  for (std::size_t k = 0; k < reference.coefficients.size(); ++k) {
    const Coefficient& expected = reference.coefficients[k];
    const double error = expected.standard_error.value_or(0.0);
    const double tolerance = form.exact_without_noise || error == 0.0
                                 ? form.rounding * std::max(std::abs(expected.value), error)
                                 : fraction * error;
    EXPECT_NEAR(other.coefficients[k].value * factor, expected.value, tolerance) << name(expected.term);
  }
}

void expect_same_bits(const Identification& a, const Identification& b, const Dataset& record) {
  ASSERT_EQ(a.coefficients.size(), b.coefficients.size());
  for (std::size_t k = 0; k < a.coefficients.size(); ++k) {
    EXPECT_EQ(a.coefficients[k].value, b.coefficients[k].value) << name(a.coefficients[k].term);
  }
  EXPECT_EQ(a.covariance, b.covariance);
  EXPECT_EQ(predict(a, record), predict(b, record));
  ASSERT_EQ(a.history.size(), b.history.size());
  for (std::size_t k = 0; k < a.history.size(); ++k) EXPECT_EQ(a.history[k].values, b.history[k].values);
}

class Law : public testing::TestWithParam<Form> {};

TEST_P(Law, SameSeedSameBitsForAnyThreads) {
  const Dataset record = test::make_twin();
  const auto with_threads = [&record](std::size_t threads) {
    const ThreadLimit limit(threads);
    return fitted(GetParam(), record);
  };
  const Identification once = with_threads(1);
  expect_same_bits(once, with_threads(1), record);
  expect_same_bits(once, with_threads(2), record);
}

TEST_P(Law, ExactWithoutNoise) {
  if (!GetParam().exact_without_noise) GTEST_SKIP() << "the method does not promise it";
  const StaticModel truth = test::paper_truth();
  const Dataset record = test::make_twin({.noise = 0.0});
  const Identification result = fitted(GetParam(), record);
  const double largest = std::abs(*std::max_element(record.output.begin(), record.output.end()));
  for (const Coefficient& c : result.coefficients) {
    double regressor_sum = 0.0;
    for (std::size_t row = 0; row < record.rows(); ++row)
      regressor_sum += std::abs(regressor(c.term, record.at(row)));
    // A coefficient's error counts by what it does to the output, which is known to 2^-53 of its size.
    const double effect =
        std::abs(c.value - truth.coefficient(c.term)) * regressor_sum / static_cast<double>(record.rows());
    EXPECT_LT(effect, 1e-14 * largest) << name(c.term);
  }
}

TEST_P(Law, RowOrderDoesNotMatter) {
  const Dataset record = test::make_twin();
  expect_same_coefficients(GetParam(), fitted(GetParam(), record), fitted(GetParam(), shuffled(record)), 1.0,
                           0.05);
}

TEST_P(Law, UnitOfAccelerationDoesNotMatter) {
  const Dataset record = test::make_twin();
  const Dataset metric = rewritten(record, find_unit("m/s^2").value());
  expect_same_coefficients(GetParam(), fitted(GetParam(), record), fitted(GetParam(), metric), 1.0, 0.1);
}

TEST_P(Law, CoefficientsScaleWithTheOutput) {
  if (!GetParam().settles) GTEST_SKIP() << "the search is far from its end";
  Dataset volts = test::make_twin();
  volts.output_unit = find_unit("V").value();
  Dataset millivolts = volts;
  millivolts.output_unit = find_unit("mV").value();
  for (double& value : millivolts.output) value *= 1000.0;
  expect_same_coefficients(GetParam(), fitted(GetParam(), volts), fitted(GetParam(), millivolts), 1e-3, 0.1);
}

// Ai alone, and an accelerometer that heeds nothing else.
Dataset input_axis_only() {
  Dataset record = test::make_twin({}, {.terms = {Term::K0, Term::Ki}, .coefficients = {1e-3, 0.9}});
  record.acceleration[1].clear();
  record.acceleration[2].clear();
  return record;
}

TEST_P(Law, RefusesRankLossNamingTheTerms) {
  const IdentifyOptions options{.terms = parse_terms("linear")};
  try {
    (void)fitted(GetParam(), input_axis_only(), options);
    ADD_FAILURE() << "no refusal";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::refused);
    EXPECT_THAT(error.what(), HasSubstr("2 of the 4 terms asked for: Ko, Kp"));
    ASSERT_EQ(error.findings().size(), 2U);
    for (const Finding& finding : error.findings()) EXPECT_EQ(finding.code, Code::term_without_column);
  }
}

TEST_P(Law, DropsLostTermsAndMarksThem) {
  if (!GetParam().takes_one_axis) GTEST_SKIP() << "the method needs two axes";
  const IdentifyOptions options{.terms = parse_terms("linear"), .on_rank_loss = RankLossPolicy::drop};
  const Identification result = fitted(GetParam(), input_axis_only(), options);
  ASSERT_EQ(result.coefficients.size(), 4U);
  EXPECT_NEAR(result.coefficients[0].value, 1e-3, 3e-4);
  EXPECT_NEAR(result.coefficients[1].value, 0.9, 1e-4);
  for (const std::size_t k : {2U, 3U}) {
    EXPECT_FALSE(result.coefficients[k].identified);
    ASSERT_TRUE(result.coefficients[k].reason.has_value());
    EXPECT_EQ(result.coefficients[k].reason->code, Code::term_without_column);
  }
}

TEST_P(Law, PredictAgreesWithTheFit) {
  const Dataset record = GetParam().with_sigma ? with_sigma(test::make_twin()) : test::make_twin();
  const IdentifyOptions options{.terms = paper_terms(), .split = kTrainingFraction};
  const Identification result = identify(record, small(GetParam()), options).identification;
  const Dataset training = record.select(split_rows(record.rows(), {}, options.seed).training);
  const Metrics again = score(training.output, predict(result, training));
  ASSERT_TRUE(result.train.has_value());
  EXPECT_EQ(result.train->n, training.rows());
  EXPECT_EQ(result.train->rmse, again.rmse);
  EXPECT_EQ(result.train->mae, again.mae);
  // And the fit is one: what it leaves is not far above the noise, or the spread of the output.
  EXPECT_GT(*result.train->r2, 0.99);
  if (result.diagnostics.residual_sd && result.diagnostics.dof) {
    const double rss = again.mse * static_cast<double>(again.n);
    EXPECT_NEAR(*result.diagnostics.residual_sd,
                std::sqrt(rss / static_cast<double>(*result.diagnostics.dof)),
                1e-9 * *result.diagnostics.residual_sd);
  }
}

INSTANTIATE_TEST_SUITE_P(AllMethods, Law, testing::ValuesIn(test::method_forms()),
                         [](const auto& form) { return form.param.label; });

}  // namespace
}  // namespace proofmass
