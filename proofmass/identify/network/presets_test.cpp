// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/presets.hpp"

#include <gtest/gtest.h>

#include "proofmass/identify/method.hpp"
#include "proofmass/numeric/network/perceptron.hpp"

namespace proofmass {
namespace {

void expect_the_papers_network(const NetworkOptions& network) {
  EXPECT_EQ((PerceptronShape{3, network.hidden.value()}.parameters()), 36U);
  EXPECT_EQ(network.training.trainer, Trainer::lm);
  EXPECT_EQ(network.training.epochs, 1000U);
  EXPECT_TRUE(network.early_stopping);
}

TEST(PaperPreset, HasThePapersNumbers) {
  PsoBp method;
  method.network.hidden.reset();
  apply_paper_preset(method);
  expect_the_papers_network(method.network);
  EXPECT_EQ(method.particles, 50U);
  EXPECT_EQ(method.iterations, 50U);
  EXPECT_EQ(method.inertia, 0.6);
  EXPECT_EQ(method.cognitive, 1.5);
  EXPECT_EQ(method.social, 1.5);
  EXPECT_EQ(method.topology, SwarmTopology::global);
  EXPECT_EQ(method.update, SwarmUpdate::synchronous);
  EXPECT_EQ(method.velocity_limit, 0.5);
  EXPECT_EQ(method.fitness, SwarmFitness::trained);
  EXPECT_EQ(method.fitness_epochs, 20U);
  EXPECT_EQ(method.refined, 1U);
}

TEST(PaperPreset, LeavesTheRestAsItWas) {
  PsoBp method;
  method.network.training.mu = 0.25;
  method.network.validation_fraction = 0.2;
  method.stall_iterations = 9;
  apply_paper_preset(method);
  EXPECT_EQ(method.network.training.mu, 0.25);
  EXPECT_EQ(method.network.validation_fraction, 0.2);
  EXPECT_EQ(method.stall_iterations, 9U);
}

TEST(PaperPreset, GivesBpTheSameNetworkAndTraining) {
  Bp method;
  method.starts = 3;
  method.start_epochs = 4;
  method.network.hidden.reset();
  method.network.training.mu = 0.25;
  apply_paper_preset(method);
  expect_the_papers_network(method.network);
  EXPECT_EQ(method.refined, 1U);
  EXPECT_EQ(method.network.training.mu, 0.25);
  EXPECT_EQ(method.starts, 3U);
  EXPECT_EQ(method.start_epochs, 4U);
}

TEST(PaperPreset, IsForMethodsThatPredictByNetwork) {
  for (const Method& method : methods()) {
    Method preset = method;
    EXPECT_EQ(apply_paper_preset(preset), info(method).predicts_by_network) << info(method).name;
    if (const NetworkOptions* network = network_options(preset)) expect_the_papers_network(*network);
  }
}

}  // namespace
}  // namespace proofmass
