// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/hybrid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/identify/regression/ols.hpp"
#include "proofmass/numeric/random.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "proofmass/stand/twin/simulation_file.hpp"
#include "support/endings.hpp"

namespace proofmass {
namespace {

Dataset twin(const std::string& name, std::uint64_t seed) {
  const SimulationPlan plan = read_simulation(std::string(PROOFMASS_SOURCE_DIR) + "/data/" + name);
  return simulate(plan, plan.rows, seed);
}

IdentifyOptions full_model(std::uint64_t seed) {
  IdentifyOptions options;
  options.terms = parse_terms("full");
  options.seed = seed;
  return options;
}

// Root mean square of the noise that was simulated in these rows.
double noise_in(const std::vector<std::size_t>& rows, const Dataset& record, std::uint64_t seed) {
  SimulationPlan quiet = read_simulation(std::string(PROOFMASS_SOURCE_DIR) + "/data/twin-unmodelled.toml");
  quiet.noise = {};
  const Dataset clean = simulate(quiet, quiet.rows, seed);
  double sum = 0.0;
  for (const std::size_t row : rows) sum += std::pow(record.output[row] - clean.output[row], 2);
  return std::sqrt(sum / static_cast<double>(rows.size()));
}

TEST(Hybrid, IsLeastSquaresWhereTheModelIsRight) {
  SilentProgress progress;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Dataset record = twin("twin-10ug.toml", seed);
    const Identification hybrid = fit(Hybrid{}, record, full_model(seed), progress);
    const Identification ols = fit(Ols{}, record, full_model(seed), progress);
    EXPECT_FALSE(hybrid.network.has_value()) << "seed " << seed << ": " << test::said(hybrid.ending);
    for (std::size_t k = 0; k < ols.coefficients.size(); ++k) {
      EXPECT_NEAR(hybrid.coefficients[k].value, ols.coefficients[k].value,
                  1e-6 * *ols.coefficients[k].standard_error);
    }
  }
}

TEST(Hybrid, PredictsUnmodelledStructureToTheNoise) {
  constexpr std::uint64_t seeds = 6;
  double product = 1.0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Dataset record = twin("twin-unmodelled.toml", seed);
    const auto run = identify(record, Hybrid{}, full_model(seed));
    const Identification& hybrid = run.identification;
    const Identification ols = identify(record, Ols{}, full_model(seed)).identification;
    const double noise = noise_in(run.split.test, record, seed);
    EXPECT_LT(hybrid.test->rmse / noise, 1.05) << "seed " << seed;
    EXPECT_GT(ols.test->rmse / noise, 1.1) << "seed " << seed;
    product *= hybrid.test->rmse / noise;
    ASSERT_TRUE(hybrid.network.has_value());
    EXPECT_EQ(hybrid.network->skip.terms.size(), 20U);
  }
  EXPECT_LT(std::pow(product, 1.0 / static_cast<double>(seeds)), 1.04);
}

TEST(Hybrid, DoesNotFollowOutliers) {
  std::size_t dropped = 0;  // of the networks that the criterion asks for
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const Identification hybrid =
        identify(twin("twin-heavy-tails.toml", seed), Hybrid{}, full_model(seed)).identification;
    EXPECT_FALSE(hybrid.network.has_value()) << test::said(hybrid.ending);
    if (test::said(hybrid.ending).find("cross-validation drops the network") != std::string::npos) ++dropped;
  }
  EXPECT_GT(dropped, 0U);
}

// Forty set-ups measured ten times each, with an error of the set-up's own: a network can follow that, and
// would find it again at repeats.
TEST(Hybrid, DoesNotTakeErrorsOfRepeatedSetUpsForStructure) {
  SilentProgress progress;
  const Dataset points = twin("twin.toml", 1);
  std::vector<std::size_t> rows;
  for (std::size_t r = 0; r < 400; ++r) rows.push_back(r % 40);
  Dataset record = points.select(rows);
  RandomStream random(1);
  for (double& output : record.output) output += 1e-7 * random.normal();
  const Identification hybrid = fit(Hybrid{}, record, {.terms = parse_terms("paper")}, progress);
  EXPECT_FALSE(hybrid.network.has_value()) << test::said(hybrid.ending);
}

TEST(Hybrid, SaysWhatEndedTheSearch) {
  SilentProgress progress;
  const Dataset record = twin("twin-unmodelled.toml", 1);
  const Ending found = fit(Hybrid{}, record, full_model(1), progress).ending;
  EXPECT_EQ(found.status, EndingStatus::converged) << test::said(found);
  EXPECT_EQ(test::said(found).find("the most allowed"), std::string::npos) << test::said(found);
  const Ending cut = fit(Hybrid{.most_hidden = 1}, record, full_model(1), progress).ending;
  EXPECT_EQ(cut.status, EndingStatus::iteration_limit);
  EXPECT_TRUE(
      test::said(cut).starts_with("the Bayesian information criterion, less that without a network: "
                                  "0 units 0.0, 1 unit -"))
      << test::said(cut);
  EXPECT_NE(test::said(cut).find("it is least with 1 hidden unit, the most allowed"), std::string::npos)
      << test::said(cut);
  const Ending short_training = fit(Hybrid{.epochs = 2}, record, full_model(1), progress).ending;
  EXPECT_EQ(short_training.status, EndingStatus::iteration_limit) << test::said(short_training);
  EXPECT_NE(test::said(short_training).find("training used all of its 2 epochs with"), std::string::npos)
      << test::said(short_training);
}

// The rows decide against a network that its epochs may not have brought to the end: the ending says so.
TEST(Hybrid, SaysThatTheTrainingOfARejectedNetworkWasCut) {
  SilentProgress progress;
  const Dataset record = twin("twin-10ug.toml", 1);
  const Ending cut = fit(Hybrid{.epochs = 1}, record, full_model(1), progress).ending;
  EXPECT_EQ(cut.status, EndingStatus::converged) << test::said(cut);
  EXPECT_NE(
      test::said(cut).find("it is least with 0 hidden units; training used all of its 1 epoch with 1, 2 "
                           "hidden units"),
      std::string::npos)
      << test::said(cut);
}

TEST(Hybrid, NeedsTheBias) {
  SilentProgress progress;
  const IdentifyOptions options{.terms = parse_terms("Ki,Kii")};
  EXPECT_THROW((void)fit(Hybrid{}, twin("twin-10ug.toml", 1), options, progress), Error);
}

}  // namespace
}  // namespace proofmass
