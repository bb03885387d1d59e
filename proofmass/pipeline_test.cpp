// SPDX-License-Identifier: Apache-2.0
#include "proofmass/pipeline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "proofmass/assess/metrics.hpp"
#include "proofmass/core/error.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;

std::vector<std::size_t> together(const Split& split) {
  std::vector<std::size_t> rows = split.training;
  rows.insert(rows.end(), split.validation.begin(), split.validation.end());
  rows.insert(rows.end(), split.test.begin(), split.test.end());
  std::sort(rows.begin(), rows.end());
  return rows;
}

RC_GTEST_PROP(SplitRows, PutsEveryRowInOnePart, ()) {
  const auto rows = *rc::gen::inRange<std::size_t>(10, 500);
  const double share = *rc::gen::inRange(30, 101) / 100.0;
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  const SplitOptions options{.training_share = share, .early_stopping = *rc::gen::arbitrary<bool>()};
  const Split split = split_rows(rows, options, seed);

  std::vector<std::size_t> all(rows);
  std::iota(all.begin(), all.end(), std::size_t{0});
  RC_ASSERT(together(split) == all);
  for (const auto* part : {&split.training, &split.validation, &split.test}) {
    RC_ASSERT(std::is_sorted(part->begin(), part->end()));
  }
  const auto n = static_cast<double>(rows);
  const auto count = [n](double part) { return static_cast<std::size_t>(std::llround(part * n)); };
  RC_ASSERT(split.training.size() + split.validation.size() == count(share));
  RC_ASSERT(split.validation.size() == (options.early_stopping ? count(0.15) : 0));

  SplitOptions other = options;
  other.early_stopping = !options.early_stopping;
  const Split again = split_rows(rows, other, seed);
  RC_ASSERT(again.test == split.test);
}

TEST(SplitRows, ValidationRowsComeOutOfTheTrainingRows) {
  const Split without = split_rows(200, {}, 5);
  const Split with = split_rows(200, {.early_stopping = true}, 5);
  EXPECT_EQ(without.training.size(), 140U);
  EXPECT_EQ(with.training.size(), 110U);
  EXPECT_EQ(with.validation.size(), 30U);
  const auto& pool = without.training;
  EXPECT_TRUE(std::includes(pool.begin(), pool.end(), with.validation.begin(), with.validation.end()));
  EXPECT_TRUE(std::includes(pool.begin(), pool.end(), with.training.begin(), with.training.end()));
}

TEST(SplitRows, DependsOnTheSeed) {
  EXPECT_EQ(split_rows(100, {}, 1).test, split_rows(100, {}, 1).test);
  EXPECT_NE(split_rows(100, {}, 1).test, split_rows(100, {}, 2).test);
}

TEST(SplitRows, AShareOfOneTakesAllRows) {
  const Split split = split_rows(31, {.training_share = 1.0}, 1);
  EXPECT_EQ(split.training.size(), 31U);
  EXPECT_TRUE(split.test.empty());
}

TEST(SplitRows, RefusesSharesThatMakeNoSense) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  std::vector<SplitOptions> bad;
  for (const double share : {0.0, -0.1, 1.01, kNan}) bad.push_back({.training_share = share});
  for (const double share : {0.7, 0.9, -0.1, kNan}) {
    bad.push_back({.validation_share = share, .early_stopping = true});
  }
  bad.push_back({.training_share = 0.04});                            // no row of ten
  bad.push_back({.validation_share = 0.68, .early_stopping = true});  // seven rows of seven
  for (const SplitOptions& options : bad) {
    try {
      (void)split_rows(10, options, 1);
      ADD_FAILURE() << options.training_share << ", " << options.validation_share;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
    }
  }
  // Without early stopping nobody asks for validation rows.
  EXPECT_NO_THROW((void)split_rows(10, {.validation_share = 0.9}, 1));
}

TEST(SplitFor, OnlyNetworksStopEarly) {
  for (const Method& method : methods()) {
    EXPECT_EQ(split_for(method, {.early_stopping = true}).early_stopping, method.predicts_by_network);
    EXPECT_FALSE(split_for(method, {}).early_stopping);
  }
}

TEST(PaperPreset, StopsEarly) {
  IdentifyOptions options;
  SplitOptions split;
  apply_paper_preset(options, split);
  EXPECT_TRUE(split.early_stopping);
  EXPECT_EQ(split.training_share, 0.7);
  EXPECT_EQ(options.swarm.particles, 50U);
}

IdentifyOptions small() {
  IdentifyOptions options;
  options.terms = parse_terms("paper");
  options.network.hidden = 3;
  options.network.epochs = 60;
  options.swarm.particles = 6;
  options.swarm.iterations = 3;
  options.uncertainty = {.input = 2e-4, .output = 3e-4};
  return options;
}

class Run : public testing::TestWithParam<Method> {};

// Rows that training must not see may hold anything.
TEST_P(Run, TestRowsTouchNothingButTheirOwnScore) {
  const Dataset record = test::make_twin();
  Dataset spoilt = record;
  for (const std::size_t row : split_rows(record.rows(), {}, 1).test) {
    spoilt.output[row] = 1e6;
    spoilt.acceleration[0][row] = -400.0;
  }
  SilentProgress progress;
  const SplitOptions split{.early_stopping = true};
  const Identification a = run(record, GetParam(), small(), split, progress);
  const Identification b = run(spoilt, GetParam(), small(), split, progress);
  ASSERT_EQ(a.coefficients.size(), b.coefficients.size());
  for (std::size_t k = 0; k < a.coefficients.size(); ++k) {
    EXPECT_EQ(a.coefficients[k].value, b.coefficients[k].value);
  }
  EXPECT_EQ(a.train->rmse, b.train->rmse);
  EXPECT_EQ(a.validation.has_value(), GetParam().predicts_by_network);
  if (a.validation) {
    EXPECT_EQ(a.validation->rmse, b.validation->rmse);
  }
  EXPECT_GT(b.test->rmse, 1e3 * a.test->rmse);
}

TEST_P(Run, ScoresEveryPartInTheDeclaredUnit) {
  Dataset record = test::make_twin();
  record.output_unit = find_unit("mV").value();
  SilentProgress progress;
  const SplitOptions options{.early_stopping = true};
  const Identification result = run(record, GetParam(), small(), options, progress);
  const Split split = split_rows(record.rows(), split_for(GetParam(), options), 1);
  const auto expect_score = [&](const std::optional<Metrics>& found, const std::vector<std::size_t>& rows) {
    ASSERT_TRUE(found.has_value());
    const Dataset part = record.select(rows);
    const std::vector<double> predicted = predict(result, part);
    double square = 0.0;
    for (std::size_t row = 0; row < predicted.size(); ++row) {
      square += std::pow((part.output[row] - predicted[row]) / record.output_unit.to_canonical, 2);
    }
    EXPECT_EQ(found->n, rows.size());
    EXPECT_NEAR(found->mse, square / static_cast<double>(rows.size()), 1e-12 * found->mse);
  };
  expect_score(result.train, split.training);
  if (!split.validation.empty()) expect_score(result.validation, split.validation);
  expect_score(result.test, split.test);
}

TEST_P(Run, FittingAllRowsLeavesNothingToTest) {
  SilentProgress progress;
  const Identification result =
      run(test::make_twin(), GetParam(), small(), {.training_share = 1.0}, progress);
  EXPECT_EQ(result.train->n, 300U);
  EXPECT_FALSE(result.validation.has_value());
  EXPECT_FALSE(result.test.has_value());
  for (const Coefficient& c : result.coefficients) {
    // A search over models may leave terms out.
    EXPECT_TRUE(c.ci95.has_value() || !c.identified) << name(c.term);
  }
}

INSTANTIATE_TEST_SUITE_P(AllMethods, Run, testing::ValuesIn(methods().begin(), methods().end()),
                         [](const auto& method) {
                           std::string label(method.param.name);
                           std::replace(label.begin(), label.end(), '-', '_');
                           return label;
                         });

TEST(RunOls, SaysWhenTestRowsAreUnlikeTheOthers) {
  SilentProgress progress;
  Dataset record = test::make_twin();
  const auto notes = [&] { return run(record, find_method("ols"), small(), {}, progress).diagnostics.notes; };
  EXPECT_THAT(notes(), testing::Not(testing::Contains(HasSubstr("on the test rows"))));
  for (const std::size_t row : split_rows(record.rows(), {}, 1).test) record.output[row] *= 1.01;
  EXPECT_THAT(notes(), testing::Contains(HasSubstr("more than three times that on the training rows")));
}

TEST(RunBp, RefusesAShareThatLeavesNoValidationRows) {
  SilentProgress progress;
  const SplitOptions none{.validation_share = 1e-4, .early_stopping = true};
  EXPECT_THROW((void)run(test::make_twin(), find_method("bp"), small(), none, progress), Error);
  EXPECT_NO_THROW((void)run(test::make_twin(), find_method("ols"), small(), none, progress));
}

// The scaling too is learned from the rows that train.
TEST(RunBp, LearnsItsScalingFromTheTrainingRows) {
  const Dataset record = test::make_twin();
  SilentProgress progress;
  const SplitOptions options{.early_stopping = true};
  const Identification result = run(record, find_method("bp"), small(), options, progress);
  const Dataset training = record.select(split_rows(record.rows(), options, 1).training);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] =
        std::minmax_element(training.acceleration[k].begin(), training.acceleration[k].end());
    EXPECT_EQ(result.network->input_range[k].low, *low);
    EXPECT_EQ(result.network->input_range[k].high, *high);
  }
  const auto [low, high] = std::minmax_element(training.output.begin(), training.output.end());
  EXPECT_EQ(result.network->output_range.low, *low);
  EXPECT_EQ(result.network->output_range.high, *high);
}

}  // namespace
}  // namespace proofmass
