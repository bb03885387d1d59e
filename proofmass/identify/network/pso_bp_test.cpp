// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/pso_bp.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/network/bp.hpp"
#include "proofmass/identify/network/presets.hpp"
#include "proofmass/identify/network/result.hpp"
#include "proofmass/identify/network/starts.hpp"
#include "proofmass/identify/regression/ols.hpp"
#include "support/networks.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;

constexpr PerceptronShape kShape{3, 3};

IdentifyOptions small() {
  IdentifyOptions options;
  options.terms = parse_terms("paper");
  options.network.hidden = kShape.hidden;
  options.network.epochs = 40;
  options.swarm.particles = 8;
  options.swarm.iterations = 5;
  return options;
}

Identification identify(const Dataset& record, const IdentifyOptions& options) {
  SilentProgress progress;
  return identify_pso_bp(record, {}, options, progress);
}

const std::vector<double>& curve(const Identification& result, std::string_view name) {
  for (const Curve& curve : result.history) {
    if (curve.name == name) return curve.values;
  }
  throw std::out_of_range(std::string(name));
}

TEST(PsoBp, TellsHowTheSwarmConverged) {
  const Identification result = identify(test::make_twin(), small());
  const auto& best = curve(result, "swarm_best");
  const auto& mean = curve(result, "swarm_mean");
  ASSERT_EQ(best.size(), 6U) << "the initial swarm and five iterations";
  ASSERT_EQ(mean.size(), 6U);
  EXPECT_TRUE(std::is_sorted(best.rbegin(), best.rend()));
  EXPECT_LT(best.back(), best.front());
  for (std::size_t k = 0; k < best.size(); ++k) EXPECT_LE(best[k], mean[k]);
  // In the unit of the training curve, which starts at a particle.
  EXPECT_GE(curve(result, "training_rmse").front(), best.back() * (1.0 - 1e-6));
  EXPECT_THAT(result.ending.reason, HasSubstr("swarm: all 5 iterations spent"));
}

TEST(PsoBp, TrainsTheParticleThatItIsGiven) {
  const Dataset record = test::make_twin();
  for (const Trainer kind : {Trainer::varpro, Trainer::lm}) {
    IdentifyOptions options = small();
    options.network.trainer = kind;
    options.swarm.fitness = kind == Trainer::varpro ? SwarmFitness::separable : SwarmFitness::forward;
    options.swarm.particles = 1;
    options.swarm.iterations = 0;
    options.swarm.initial = {random_start(kShape, kind, 77, 0)};
    const Identification result = identify(record, options);
    SilentProgress progress;
    options.seed = 77;
    const Identification expected = identify_bp(record, {}, options, progress);
    EXPECT_EQ(result.network->weights, expected.network->weights);
  }
}

TEST(PsoBp, ChecksTheInitialSwarm) {
  IdentifyOptions options = small();
  apply_paper_preset(options);  // 36 weights a particle
  options.swarm.initial = {random_start({3, 7}, Trainer::varpro, 1, 0)};
  try {
    (void)identify(test::make_twin(), options);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_THAT(error.what(), HasSubstr("28 weights, expected 36"));
  }
  options.swarm.initial.assign(options.swarm.particles + 1, random_start({3, 7}, Trainer::lm, 1, 0));
  EXPECT_THROW((void)identify(test::make_twin(), options), Error) << "more positions than particles";
}

// One network in three guises: as it is, with a unit's sign turned, with two units exchanged.
TEST(PsoBp, RefinesOneNetworkOnlyOnce) {
  IdentifyOptions options = small();
  options.network.trainer = Trainer::lm;
  options.swarm.fitness = SwarmFitness::forward;
  options.swarm.iterations = 0;
  options.swarm.particles = 3;
  const std::vector<double> one = random_start(kShape, Trainer::lm, 3, 0);
  std::vector<double> turned = one;
  for (const std::size_t k : {0U, 1U, 2U, 9U, 12U}) turned[k] = -turned[k];
  std::vector<double> exchanged = one;
  for (std::size_t k = 0; k < 3; ++k) std::swap(exchanged[k], exchanged[3 + k]);
  std::swap(exchanged[9], exchanged[10]);
  std::swap(exchanged[12], exchanged[13]);
  options.swarm.initial = {one, turned, exchanged};
  EXPECT_THAT(identify(test::make_twin(), options).ending.reason, HasSubstr("of 1 candidates"));
  options.swarm.initial.pop_back();  // the third particle is then another network
  EXPECT_THAT(identify(test::make_twin(), options).ending.reason, HasSubstr("of 2 candidates"));
  options.swarm.refined = 1;
  EXPECT_THAT(identify(test::make_twin(), options).ending.reason, HasSubstr("of 1 candidates"));
}

TEST(PsoBp, CountsTheEpochsOfTheFitness) {
  IdentifyOptions options = small();
  apply_paper_preset(options);
  options.network.epochs = 40;
  options.swarm.particles = 4;
  options.swarm.iterations = 3;
  options.swarm.fitness_epochs = 5;
  const Identification result = identify(test::make_twin(), options);
  EXPECT_EQ(result.diagnostics.training_epochs, 4U * (1 + 3) * 5 + 40);
  EXPECT_EQ(result.diagnostics.swarm_evaluations, 4U * (1 + 3));
  EXPECT_EQ(result.network->weights.size(), 36U);
}

TEST(PsoBp, EndsAtTheTargetAndOnAStall) {
  IdentifyOptions options = small();
  options.swarm.target = 1e9;
  EXPECT_THAT(identify(test::make_twin(), options).ending.reason, HasSubstr("below the target"));
  options.swarm.target.reset();
  options.swarm.iterations = 50;
  options.swarm.stall_iterations = 2;
  options.swarm.inertia = options.swarm.cognitive = options.swarm.social = 0.0;  // nothing moves
  const Identification result = identify(test::make_twin(), options);
  EXPECT_EQ(curve(result, "swarm_best").size(), 3U);
  EXPECT_THAT(result.ending.reason, HasSubstr("no better value in 2 iterations"));
}

// The defaults on a record whose noise the network can reach: within five per cent of least squares with all
// terms, and coefficients as certain.
TEST(PsoBp, ReachesTheFloor) {
  const Dataset record = test::make_twin({.rows = 700, .noise = 1e-5});
  IdentifyOptions options;
  options.terms = parse_terms("full");
  const Identification result = identify(record, options);
  SilentProgress progress;
  const Identification floor = identify_ols(record, {}, options, progress);
  EXPECT_LT(*result.diagnostics.residual_sd, 1.05 * *floor.diagnostics.residual_sd);
  const StaticModel truth = test::paper_truth();
  for (const Coefficient& c : result.coefficients) {
    EXPECT_NEAR(c.value, truth.coefficient(c.term), 5.0 * *c.standard_error) << name(c.term);
  }
}

TEST(PsoBp, StopsWhenTheCallerAsks) {
  for (const std::size_t updates : {1U, 6U}) {  // in the swarm, in training
    test::CancelAfter progress(updates);
    IdentifyOptions options = small();
    options.network.epochs = 1000;
    try {
      (void)identify_pso_bp(test::make_twin(), {}, options, progress);
      ADD_FAILURE() << "went on";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::interrupted);
    }
  }
}

}  // namespace
}  // namespace proofmass
