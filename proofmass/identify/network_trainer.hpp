// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "proofmass/identify/options.hpp"
#include "proofmass/numeric/perceptron.hpp"
#include "proofmass/numeric/samples.hpp"
#include "proofmass/numeric/termination.hpp"

namespace proofmass {

// A network on its way through training.
struct TrainingState {
  std::vector<double> weights;  // all of them; those of the best validation epoch when there are such rows
  std::vector<double> point;  // all of them, where training stands; equal to weights without validation rows
  std::size_t failures = 0;   // successive epochs so far without a better validation error
  double training_rmse = std::numeric_limits<double>::infinity();  // of the scaled output
  double validation_rmse =
      std::numeric_limits<double>::infinity();  // likewise; infinite without validation rows
  std::vector<double> training_curve;           // rmse at the start and after each epoch
  std::vector<double> validation_curve;         // likewise; empty without validation rows
  std::size_t epochs = 0;
  double mu = 0.0;        // damping to go on with
  bool finished = false;  // further epochs would change nothing
  Termination termination;
};

// Trains networks on scaled samples with one of the two trainers.
class NetworkTrainer {
 public:
  // Keeps references. `validation` may be null: then nothing stops early.
  NetworkTrainer(const PerceptronShape& shape, const Samples& training, const Samples* validation,
                 const NetworkOptions& options);

  // A network to train from hidden weights alone (the output layer is then solved) or from all weights.
  [[nodiscard]] TrainingState start(std::vector<double> weights) const;
  // Up to `epochs` further epochs. `keep_going` is asked after each.
  void train(TrainingState& state, std::size_t epochs, const std::function<bool()>& keep_going) const;
  // What candidates are compared by: the validation error where there is one, otherwise the training error.
  [[nodiscard]] double merit(const TrainingState& state) const noexcept;

 private:
  PerceptronShape shape_;
  const Samples& training_;
  const Samples* validation_;
  const NetworkOptions& options_;
};

// Output weights that fit the samples best with the hidden weights given, appended to them.
[[nodiscard]] std::vector<double> with_solved_output_layer(const PerceptronShape& shape,
                                                           const Samples& samples,
                                                           std::vector<double> hidden_weights);

}  // namespace proofmass
