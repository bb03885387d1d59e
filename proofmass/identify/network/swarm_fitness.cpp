// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/swarm_fitness.hpp"

#include "proofmass/identify/network/separable_pool_internal.hpp"
#include "proofmass/identify/network/training/trainer.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"

namespace proofmass {

SwarmFitnessFunction::SwarmFitnessFunction(const PerceptronShape& shape, const Samples& samples,
                                           const PsoBp& method, const Progress& progress)
    : shape_(shape),
      samples_(samples),
      training_(method.network.training),
      fitness_(method.fitness),
      fitness_epochs_(method.fitness_epochs),
      progress_(progress),
      separable_(std::make_unique<const SeparablePool>(shape_, samples, kNoColumns)) {
  training_.trainer = Trainer::lm;
}

SwarmFitnessFunction::~SwarmFitnessFunction() = default;

double SwarmFitnessFunction::operator()(std::span<const double> position) const {
  if (fitness_ == SwarmFitness::separable) return separable_->rmse(position);
  if (fitness_ == SwarmFitness::trained) return trained(position);
  return root_mean(perceptron_sse(shape_, position, samples_), samples_);
}

double SwarmFitnessFunction::trained(std::span<const double> position) const {
  const NetworkTrainer trainer(shape_, samples_, nullptr, training_);
  TrainingState state = trainer.start({position.begin(), position.end()});
  trainer.train(state, fitness_epochs_, [this] { return !progress_.cancelled(); });
  epochs_ += state.epochs;
  return state.training_rmse;
}

}  // namespace proofmass
