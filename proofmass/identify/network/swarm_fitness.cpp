// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/swarm_fitness.hpp"

#include "proofmass/identify/network/separable_pool_internal.hpp"
#include "proofmass/identify/network/trainer.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"

namespace proofmass {

SwarmFitnessFunction::SwarmFitnessFunction(const PerceptronShape& shape, const Samples& samples,
                                           const IdentifyOptions& options, const Progress& progress)
    : shape_(shape),
      samples_(samples),
      network_(options.network),
      fitness_(options.swarm.fitness),
      fitness_epochs_(options.swarm.fitness_epochs),
      progress_(progress),
      separable_(std::make_unique<const SeparablePool>(shape_, samples, kNoColumns)) {
  network_.trainer = Trainer::lm;
}

SwarmFitnessFunction::~SwarmFitnessFunction() = default;

double SwarmFitnessFunction::operator()(std::span<const double> position) const {
  if (fitness_ == SwarmFitness::separable) return separable_->rmse(position);
  if (fitness_ == SwarmFitness::trained) return trained(position);
  return root_mean(perceptron_sse(shape_, position, samples_), samples_);
}

double SwarmFitnessFunction::trained(std::span<const double> position) const {
  const NetworkTrainer trainer(shape_, samples_, nullptr, network_);
  TrainingState state = trainer.start({position.begin(), position.end()});
  trainer.train(state, fitness_epochs_, [this] { return !progress_.cancelled(); });
  epochs_ += state.epochs;
  return state.training_rmse;
}

}  // namespace proofmass
