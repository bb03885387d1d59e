// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>

#include "proofmass/core/progress.hpp"
#include "proofmass/identify/network/pso_bp.hpp"
#include "proofmass/numeric/network/perceptron.hpp"
#include "proofmass/numeric/samples.hpp"

namespace proofmass {

class SeparablePool;

// The root mean square error of the network that a particle stands for, over the training samples, scaled
// output:
// - separable: hidden weights, the output layer solved by least squares;
// - trained: all weights, after a few epochs of the plain trainer (the particle itself stays where it is);
// - forward: all weights, as they are.
// Safe to call from several threads.
class SwarmFitnessFunction {
 public:
  SwarmFitnessFunction(const PerceptronShape& shape, const Samples& samples, const PsoBp& method,
                       const Progress& progress);
  ~SwarmFitnessFunction();
  [[nodiscard]] double operator()(std::span<const double> position) const;
  // Training epochs spent so far.
  [[nodiscard]] std::size_t epochs() const noexcept { return epochs_; }

 private:
  [[nodiscard]] double trained(std::span<const double> position) const;

  PerceptronShape shape_;
  const Samples& samples_;
  TrainingOptions training_;
  SwarmFitness fitness_;
  std::size_t fitness_epochs_;
  const Progress& progress_;
  mutable std::atomic<std::size_t> epochs_{0};
  std::unique_ptr<const SeparablePool> separable_;
};

}  // namespace proofmass
