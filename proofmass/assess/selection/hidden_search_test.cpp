// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/selection/hidden_search.hpp"

#include <gmock/gmock.h>

#include "proofmass/core/error.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "proofmass/pipeline.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

HiddenTrial trial(std::size_t hidden, double mean, double spread) {
  return {.hidden = hidden,
          .weights = 5 * hidden + 1,
          .validation_rmse = std::vector<double>(4, mean),
          .mean = mean,
          .best = mean,
          .spread = spread};
}

IdentifyOptions searching() {
  IdentifyOptions options;
  options.terms = parse_terms("quadratic");
  options.network.search_hidden = true;
  options.network.search_repeats = 2;
  options.network.epochs = 30;
  return options;
}

std::vector<HiddenTrial> try_sizes(const Dataset& record, const IdentifyOptions& options) {
  SilentProgress progress;
  const SplitOptions split;
  return try_hidden_sizes(
      record, find_method("bp"), options,
      split_for_trials(record.rows(), split, options.seed, options.network.search_repeats),
      split.early_stopping, progress);
}

TEST(HiddenSizes, FollowTheRuleOfThePaper) {
  EXPECT_THAT(hidden_sizes(3), testing::ElementsAre(3, 4, 5, 6, 7, 8, 9, 10, 11, 12));
  EXPECT_THAT(hidden_sizes(1), testing::ElementsAre(2, 3, 4, 5, 6, 7, 8, 9, 10, 11));  // sqrt(2) rounds to 1
}

TEST(HiddenSizes, TheFewestWithinOneStandardErrorOfTheLeastMean) {
  // The standard error of the least mean is 0.4 / sqrt(4) = 0.2; the spread of the others does not count.
  const std::vector<HiddenTrial> trials{trial(3, 2.0, 9.0), trial(4, 1.21, 9.0), trial(5, 1.19, 0.0),
                                        trial(6, 1.0, 0.4), trial(7, 1.1, 0.0)};
  EXPECT_EQ(choose_hidden(trials), 2U);
}

TEST(HiddenSearch, FindsTheSizeThatTheRecordNeedsAndUsesIt) {
  const Dataset record = test::make_twin({.rows = 400, .noise = 1e-4});
  SilentProgress progress;
  const Identification result = run(record, find_method("bp"), searching(), {}, progress);
  const auto& trials = result.diagnostics.hidden_search;
  ASSERT_EQ(trials.size(), 10U);
  ASSERT_TRUE(result.network.has_value());
  const std::size_t chosen = choose_hidden(trials);
  EXPECT_EQ(result.network->hidden, trials[chosen].hidden);
  for (std::size_t k = 0; k < trials.size(); ++k) EXPECT_EQ(trials[k].chosen, k == chosen);
  // Three units cannot follow three odd and even powers; what is chosen does as well as the best.
  EXPECT_GT(trials[chosen].hidden, 3U);
  EXPECT_GT(trials.front().mean, 1.5 * trials[chosen].mean);
}

TEST(HiddenSearch, SameBitsForAnyNumberOfThreads) {
  const Dataset record = test::make_twin({.rows = 200});
  IdentifyOptions options = searching();
  options.network.epochs = 5;
  const auto trials_with = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    std::vector<double> all;
    for (const HiddenTrial& one : try_sizes(record, options)) {
      all.insert(all.end(), one.validation_rmse.begin(), one.validation_rmse.end());
    }
    return all;
  };
  EXPECT_EQ(trials_with(1), trials_with(2));
}

TEST(HiddenSearch, LeavesOutSizesThatTheRowsCannotTrain) {
  const Dataset record = test::make_twin({.rows = 50});
  IdentifyOptions options = searching();
  options.network.epochs = 3;
  // 50 rows less the 15 of 70 that are set aside are 39: seven units have 36 weights, eight 41.
  EXPECT_EQ(try_sizes(record, options).size(), 5U);
  const Dataset few = test::make_twin({.rows = 15});
  EXPECT_THROW((void)try_sizes(few, options), Error);
}

TEST(HiddenSearch, DoesNotTouchMethodsWithoutSuchANetwork) {
  const Dataset record = test::make_twin({.rows = 100});
  SilentProgress progress;
  const Identification result = run(record, find_method("ols"), searching(), {}, progress);
  EXPECT_TRUE(result.diagnostics.hidden_search.empty());
}

}  // namespace
}  // namespace proofmass
