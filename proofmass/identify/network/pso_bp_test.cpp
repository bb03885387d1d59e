// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/pso_bp.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/identify/network/bp.hpp"
#include "proofmass/identify/network/presets.hpp"
#include "proofmass/identify/network/result.hpp"
#include "proofmass/identify/network/training/starts.hpp"
#include "proofmass/identify/regression/ols.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "support/endings.hpp"
#include "support/networks.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

using testing::HasSubstr;

constexpr PerceptronShape kShape{3, 3};

PsoBp small() {
  PsoBp method;
  method.network.hidden = kShape.hidden;
  method.grow_to = 0;
  method.network.training.epochs = 40;
  method.particles = 8;
  method.iterations = 5;
  return method;
}

Identification fitted(const Dataset& record, const PsoBp& method) {
  SilentProgress progress;
  return fit(method, record, {}, {.terms = parse_terms("paper")}, progress);
}

const std::vector<double>& curve(const Identification& result, std::string_view name) {
  for (const Curve& curve : result.history) {
    if (curve.name == name) return curve.values;
  }
  throw std::out_of_range(std::string(name));
}

TEST(PsoBp, TellsHowTheSwarmConverged) {
  const Identification result = fitted(test::make_twin(), small());
  const auto& best = curve(result, "swarm_best");
  const auto& mean = curve(result, "swarm_mean");
  ASSERT_EQ(best.size(), 6U) << "the initial swarm and five iterations";
  ASSERT_EQ(mean.size(), 6U);
  EXPECT_TRUE(std::is_sorted(best.rbegin(), best.rend()));
  EXPECT_LT(best.back(), best.front());
  for (std::size_t k = 0; k < best.size(); ++k) EXPECT_LE(best[k], mean[k]);
  // In the unit of the training curve, which starts at a particle.
  EXPECT_GE(curve(result, "training_rmse").front(), best.back() * (1.0 - 1e-6));
  EXPECT_THAT(test::said(result.ending), HasSubstr("swarm: all 5 iterations spent"));
}

TEST(PsoBp, TrainsTheParticleThatItIsGiven) {
  const Dataset record = test::make_twin();
  for (const Trainer kind : {Trainer::varpro, Trainer::lm}) {
    PsoBp method = small();
    method.network.training.trainer = kind;
    method.fitness = kind == Trainer::varpro ? SwarmFitness::separable : SwarmFitness::forward;
    method.particles = 1;
    method.iterations = 0;
    method.initial = {random_start(kShape, kind, 77, 0)};
    const Identification result = fitted(record, method);
    SilentProgress progress;
    const Identification expected =
        fit(Bp{.network = method.network}, record, {}, {.terms = parse_terms("paper"), .seed = 77}, progress);
    EXPECT_EQ(result.network->weights, expected.network->weights);
  }
}

TEST(PsoBp, ChecksTheInitialSwarm) {
  PsoBp method = small();
  apply_paper_preset(method);  // 36 weights a particle
  method.initial = {random_start({3, 7}, Trainer::varpro, 1, 0)};
  try {
    (void)fitted(test::make_twin(), method);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_THAT(error.what(), HasSubstr("28 weights, expected 36"));
  }
  method.initial.assign(method.particles + 1, random_start({3, 7}, Trainer::lm, 1, 0));
  EXPECT_THROW((void)fitted(test::make_twin(), method), Error) << "more positions than particles";
}

// One network in three guises: as it is, with a unit's sign turned, with two units exchanged.
TEST(PsoBp, RefinesOneNetworkOnlyOnce) {
  PsoBp method = small();
  method.network.training.trainer = Trainer::lm;
  method.fitness = SwarmFitness::forward;
  method.iterations = 0;
  method.particles = 3;
  const std::vector<double> one = random_start(kShape, Trainer::lm, 3, 0);
  std::vector<double> turned = one;
  for (const std::size_t k : {0U, 1U, 2U, 9U, 12U}) turned[k] = -turned[k];
  std::vector<double> exchanged = one;
  for (std::size_t k = 0; k < 3; ++k) std::swap(exchanged[k], exchanged[3 + k]);
  std::swap(exchanged[9], exchanged[10]);
  std::swap(exchanged[12], exchanged[13]);
  method.initial = {one, turned, exchanged};
  EXPECT_THAT(test::said(fitted(test::make_twin(), method).ending), HasSubstr("of 1 candidate)"));
  method.initial.pop_back();  // the third particle is then another network
  EXPECT_THAT(test::said(fitted(test::make_twin(), method).ending), HasSubstr("of 2 candidates"));
  method.refined = 1;
  EXPECT_THAT(test::said(fitted(test::make_twin(), method).ending), HasSubstr("of 1 candidate)"));
}

TEST(PsoBp, CountsTheEpochsOfTheFitness) {
  PsoBp method = small();
  apply_paper_preset(method);
  method.network.training.epochs = 40;
  method.particles = 4;
  method.iterations = 3;
  method.fitness_epochs = 5;
  const Identification result = fitted(test::make_twin(), method);
  const auto& details = std::get<NetworkDetails>(result.details);
  EXPECT_EQ(details.training_epochs, 4U * (1 + 3) * 5 + 40);
  EXPECT_EQ(details.swarm_evaluations, 4U * (1 + 3));
  EXPECT_EQ(result.network->weights.size(), 36U);
}

TEST(PsoBp, EndsAtTheTargetAndOnAStall) {
  PsoBp method = small();
  method.target = 1e9;
  EXPECT_THAT(test::said(fitted(test::make_twin(), method).ending), HasSubstr("below the target"));
  method.target.reset();
  method.iterations = 50;
  method.stall_iterations = 2;
  method.inertia = method.cognitive = method.social = 0.0;  // nothing moves
  const Identification result = fitted(test::make_twin(), method);
  EXPECT_EQ(curve(result, "swarm_best").size(), 3U);
  EXPECT_THAT(test::said(result.ending), HasSubstr("no better value in 2 iterations"));
}

// The defaults on a record whose noise the network can reach: within five per cent of least squares with all
// terms, and coefficients as certain.
TEST(PsoBp, ReachesTheFloor) {
  const Dataset record = test::make_twin({.rows = 700, .noise = 1e-5});
  const IdentifyOptions options{.terms = parse_terms("full")};
  SilentProgress progress;
  const Identification result = fit(PsoBp{}, record, {}, options, progress);
  const Identification floor = fit(Ols{}, record, options, progress);
  EXPECT_LT(*result.diagnostics.residual_sd, 1.05 * *floor.diagnostics.residual_sd);
  const StaticModel truth = test::paper_truth();
  for (const Coefficient& c : result.coefficients) {
    EXPECT_NEAR(c.value, truth.coefficient(c.term), 5.0 * *c.standard_error) << name(c.term);
  }
}

TEST(PsoBp, HasExactlyTheUnitsAskedFor) {
  Method method = PsoBp{};
  set_hidden(method, 3);
  EXPECT_EQ(std::get<PsoBp>(method).network.hidden, 3U);
  EXPECT_EQ(std::get<PsoBp>(method).grow_to, 0U);
  const Identification result = fitted(test::make_twin(), small());
  EXPECT_EQ(result.network->hidden, kShape.hidden);
  EXPECT_FALSE(mentions(result.ending.parts, EndingCode::units_suffice));
}

// Three units cannot represent the twin; the network that grows has the same bits for any number of threads.
TEST(PsoBp, GrowsAlikeForAnyNumberOfThreads) {
  PsoBp method = small();
  method.grow_to = 5;
  const Dataset record = test::make_twin();
  const Identification grown = fitted(record, method);
  EXPECT_TRUE(mentions(grown.ending.parts, EndingCode::units_added)) << test::said(grown.ending);
  EXPECT_EQ(grown.network->hidden, 5U);
  EXPECT_LT(*grown.diagnostics.residual_sd, *fitted(record, small()).diagnostics.residual_sd);
  const ThreadLimit one(1);
  EXPECT_EQ(fitted(record, method).network->weights, grown.network->weights);
}

TEST(PsoBp, StopsWhenTheCallerAsks) {
  for (const std::size_t updates : {1U, 6U}) {  // in the swarm, in training
    test::CancelAfter progress(updates);
    PsoBp method = small();
    method.network.training.epochs = 1000;
    try {
      (void)fit(method, test::make_twin(), {}, {.terms = parse_terms("paper")}, progress);
      ADD_FAILURE() << "went on";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::interrupted);
    }
  }
}

}  // namespace
}  // namespace proofmass
