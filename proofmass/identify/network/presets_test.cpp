// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/presets.hpp"

#include <gtest/gtest.h>

#include "proofmass/numeric/network/perceptron.hpp"

namespace proofmass {
namespace {

TEST(PaperPreset, HasThePapersNumbers) {
  IdentifyOptions options;
  apply_paper_preset(options);
  EXPECT_EQ((PerceptronShape{3, options.network.hidden}.parameters()), 36U);
  EXPECT_EQ(options.network.trainer, Trainer::lm);
  EXPECT_EQ(options.network.epochs, 1000U);
  EXPECT_EQ(options.swarm.particles, 50U);
  EXPECT_EQ(options.swarm.iterations, 50U);
  EXPECT_EQ(options.swarm.inertia, 0.6);
  EXPECT_EQ(options.swarm.cognitive, 1.5);
  EXPECT_EQ(options.swarm.social, 1.5);
  EXPECT_EQ(options.swarm.topology, SwarmTopology::global);
  EXPECT_EQ(options.swarm.update, SwarmUpdate::synchronous);
  EXPECT_EQ(options.swarm.velocity_limit, 0.5);
  EXPECT_EQ(options.swarm.fitness, SwarmFitness::trained);
  EXPECT_EQ(options.swarm.fitness_epochs, 20U);
  EXPECT_EQ(options.swarm.refined, 1U);
}

TEST(PaperPreset, LeavesTheRestAsItWas) {
  IdentifyOptions options;
  options.terms = parse_terms("linear");
  options.seed = 9;
  options.network.mu = 0.25;
  apply_paper_preset(options);
  EXPECT_EQ(options.terms, parse_terms("linear"));
  EXPECT_EQ(options.seed, 9U);
  EXPECT_EQ(options.network.mu, 0.25);
}

}  // namespace
}  // namespace proofmass
