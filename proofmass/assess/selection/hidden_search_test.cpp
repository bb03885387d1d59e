// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/selection/hidden_search.hpp"

#include <gmock/gmock.h>

#include "proofmass/core/error.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/split.hpp"
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

Bp searching() {
  Bp method;
  method.network.hidden.reset();
  method.network.search_repeats = 2;
  method.network.training.epochs = 30;
  return method;
}

IdentifyOptions quadratic_model() { return {.terms = parse_terms("quadratic")}; }

std::vector<HiddenTrial> try_sizes(const Dataset& record, const Bp& method) {
  SilentProgress progress;
  const IdentifyOptions options = quadratic_model();
  const SplitOptions split{.validation_fraction = method.network.validation_fraction};
  return try_hidden_sizes(record, method, options,
                          split_for_trials(record.rows(), split, options.seed, method.network.search_repeats),
                          progress);
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
  const Identification result = identify(record, searching(), quadratic_model()).identification;
  const auto& trials = std::get<NetworkDetails>(result.details).hidden_search;
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
  Bp method = searching();
  method.network.training.epochs = 5;
  const auto trials_with = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    std::vector<double> all;
    for (const HiddenTrial& one : try_sizes(record, method)) {
      all.insert(all.end(), one.validation_rmse.begin(), one.validation_rmse.end());
    }
    return all;
  };
  EXPECT_EQ(trials_with(1), trials_with(2));
}

TEST(HiddenSearch, LeavesOutSizesThatTheRowsCannotTrain) {
  const Dataset record = test::make_twin({.rows = 50});
  Bp method = searching();
  method.network.training.epochs = 3;
  // 50 rows less the 15 of 70 that are set aside are 39: seven units have 36 weights, eight 41.
  EXPECT_EQ(try_sizes(record, method).size(), 5U);
  const Dataset few = test::make_twin({.rows = 15});
  EXPECT_THROW((void)try_sizes(few, method), Error);
}

TEST(HiddenSearch, IsMadeOnlyWhenItIsAskedFor) {
  const Dataset record = test::make_twin({.rows = 100});
  Bp given = searching();
  given.network.hidden = 3;
  given.network.training.epochs = 3;
  const Identification network = identify(record, given, quadratic_model()).identification;
  EXPECT_EQ(network.network->hidden, 3U);
  EXPECT_TRUE(std::get<NetworkDetails>(network.details).hidden_search.empty());
  const Identification ols = identify(record, Ols{}, quadratic_model()).identification;
  EXPECT_TRUE(std::holds_alternative<std::monostate>(ols.details));
}

}  // namespace
}  // namespace proofmass
