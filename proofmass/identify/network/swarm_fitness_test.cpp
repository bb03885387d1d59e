// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/swarm_fitness.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/identify/network/training/trainer.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "support/networks.hpp"
#include "support/twin.hpp"

namespace proofmass {
namespace {

constexpr PerceptronShape kShape{3, 5};

class Fitness : public testing::Test {
 protected:
  [[nodiscard]] SwarmFitnessFunction make(SwarmFitness kind) {
    method_.fitness = kind;
    return {kShape, samples_, method_, progress_};
  }
  [[nodiscard]] double rmse(const std::vector<double>& weights) const {
    return std::sqrt(perceptron_sse(kShape, weights, samples_) / static_cast<double>(samples_.rows()));
  }

  const Dataset record_ = test::make_twin({.rows = 100});
  const TrainedNetwork scaling_ = learn_scaling(record_);
  const Samples samples_ = scale_rows(scaling_, record_);
  const std::vector<double> all_ = random_start(kShape, Trainer::lm, 1, 0);
  const std::vector<double> hidden_ = random_start(kShape, Trainer::varpro, 1, 0);
  PsoBp method_;
  SilentProgress progress_;
};

TEST_F(Fitness, ForwardIsTheErrorOfTheNetworkAsItIs) {
  TrainedNetwork network = scaling_;
  network.hidden = kShape.hidden;
  network.weights = all_;
  long double square = 0.0L;
  for (std::size_t row = 0; row < record_.rows(); ++row) {
    const long double error = test::network_output(network, record_.at(row)) - record_.output[row];
    square += error * error;
  }
  const double expected =
      static_cast<double>(std::sqrt(square / record_.rows())) / output_half_range(network);
  const SwarmFitnessFunction fitness = make(SwarmFitness::forward);
  EXPECT_NEAR(fitness(all_), expected, 1e-12 * expected);
  EXPECT_EQ(fitness.epochs(), 0U);
}

TEST_F(Fitness, SeparableIsTheErrorWithTheBestOutputLayer) {
  const SwarmFitnessFunction fitness = make(SwarmFitness::separable);
  const double expected = rmse(with_solved_output_layer(kShape, samples_, hidden_));
  EXPECT_NEAR(fitness(hidden_), expected, 1e-9 * expected);
  EXPECT_LT(expected, rmse(all_));
  EXPECT_EQ(fitness.epochs(), 0U);
}

TEST_F(Fitness, TrainedIsTheErrorAfterAFewEpochsOfThePlainTrainer) {
  // For the refinement; the fitness keeps to the plain trainer.
  method_.network.training.trainer = Trainer::varpro;
  method_.network.training.mu = 0.01;
  method_.fitness_epochs = 7;
  const SwarmFitnessFunction fitness = make(SwarmFitness::trained);
  const std::vector<double> before = all_;
  const double value = fitness(all_);
  EXPECT_EQ(all_, before) << "the particle moved";
  EXPECT_EQ(fitness.epochs(), 7U);

  TrainingOptions plain = method_.network.training;
  plain.trainer = Trainer::lm;
  const NetworkTrainer trainer(kShape, samples_, nullptr, plain);
  TrainingState state = trainer.start(all_);
  trainer.train(state, 7, test::always);
  EXPECT_EQ(value, state.training_rmse);
  EXPECT_LT(value, rmse(all_));
}

// A working storage that remembered the position before would show here.
TEST_F(Fitness, DependsOnThePositionAlone) {
  constexpr std::size_t kPositions = 40;
  for (const SwarmFitness kind : {SwarmFitness::separable, SwarmFitness::trained, SwarmFitness::forward}) {
    const Trainer layout = kind == SwarmFitness::separable ? Trainer::varpro : Trainer::lm;
    std::vector<double> fresh(kPositions);
    std::vector<double> shared(kPositions);
    for (std::size_t i = 0; i < kPositions; ++i) fresh[i] = make(kind)(random_start(kShape, layout, 1, i));
    const SwarmFitnessFunction fitness = make(kind);
    const ThreadLimit two(2);
    parallel_for(kPositions, [&](std::size_t i) { shared[i] = fitness(random_start(kShape, layout, 1, i)); });
    EXPECT_EQ(shared, fresh);
  }
}

}  // namespace
}  // namespace proofmass
