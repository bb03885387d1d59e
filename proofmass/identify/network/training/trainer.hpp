// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "proofmass/core/ending.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/identify/network/training/options.hpp"
#include "proofmass/numeric/network/perceptron.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"
#include "proofmass/numeric/optimise/levenberg_marquardt.hpp"
#include "proofmass/numeric/optimise/termination.hpp"
#include "proofmass/numeric/random.hpp"
#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// A network on its way through training.
struct TrainingState {
  std::vector<double> weights;  // all of them, the best so far: by the validation rows if there are any
  std::vector<double> point;    // all of them, where training stands
  std::size_t failures = 0;     // successive epochs so far without a better validation error
  double training_rmse = std::numeric_limits<double>::infinity();  // of the scaled output
  double validation_rmse =
      std::numeric_limits<double>::infinity();  // likewise; infinite without validation rows
  std::vector<double> training_curve;           // rmse at the start and, the best so far, after each epoch
  std::vector<double> validation_curve;         // likewise; empty without validation rows
  TrainingPath path;                            // of all weights
  std::size_t epochs = 0;
  double mu = 0.0;                     // damping to go on with
  std::size_t perturbations = 0;       // perturbations so far
  std::size_t idle_perturbations = 0;  // the last of them, without gain
  double settled =
      std::numeric_limits<double>::infinity();  // least sum of squares that training came to rest at
  RandomStream random{0};                       // for the perturbations
  bool finished = false;                        // further training would change nothing
  Termination termination;
  // Whether training that comes to rest rests at a minimum: by variable projection, whose trainer perturbs
  // and polishes what rests; textbook Levenberg-Marquardt may rest anywhere.
  bool rests_at_minimum = false;
};

// Trains networks on scaled samples with one of the two trainers.
class NetworkTrainer {
 public:
  // Keeps references. `validation` may be null: then nothing stops early.
  NetworkTrainer(const PerceptronShape& shape, const Samples& training, const Samples* validation,
                 const TrainingOptions& options);
  // With further columns that the output is linear in, as SeparablePerceptron has them; their weights follow
  // the network's. By variable projection alone, else std::invalid_argument.
  NetworkTrainer(const PerceptronShape& shape, const Samples& training, const ColumnBlock& fixed,
                 const TrainingOptions& options);

  // A network to train from hidden weights alone (the output layer is then solved) or from all weights.
  // `random` is for perturbations.
  [[nodiscard]] TrainingState start(std::vector<double> weights,
                                    RandomStream random = RandomStream(0, stream_id("kick"))) const;
  // Up to `epochs` further epochs. `keep_going` is asked after each. With variable projection and no
  // validation rows, training that comes to rest is perturbed and goes on, until `perturbations` of them in a
  // row have not helped: near-degenerate units with huge output weights, whose rounding hides further
  // progress, come apart.
  void train(TrainingState& state, std::size_t epochs, const std::function<bool()>& keep_going) const;
  // Up to `epochs` further epochs to the minimum that training by variable projection came to rest near; none
  // where something else ended it, or validation rows did.
  void polish(TrainingState& state, std::size_t epochs, const std::function<bool()>& keep_going) const;
  // What candidates are compared by: the validation error where there is one, otherwise the training error.
  [[nodiscard]] double merit(const TrainingState& state) const noexcept;

 private:
  // Over the training samples, with the best weights of the further columns.
  [[nodiscard]] double sum_of_squares(std::span<const double> weights) const;
  [[nodiscard]] LevenbergMarquardtOptions settings(const TrainingState& state) const;
  // Returns the sum of squares at the point taken.
  double take(LevenbergMarquardtResult&& result, TrainingState& state) const;
  // Moves a state that has come to rest at the sum of squares to where it goes on; false when it is done.
  [[nodiscard]] bool go_on(TrainingState& state, double sum_of_squares) const;

  PerceptronShape shape_;
  const Samples& training_;
  const Samples* validation_;
  const ColumnBlock& fixed_;
  const TrainingOptions& options_;
};

// Why the training of a network ended. One that rests at a minimum has converged: nothing is left to gain.
[[nodiscard]] Ending training_end(const TrainingState& state);

// Output weights that fit the samples best with the hidden weights given, appended to them; then those of the
// further columns.
[[nodiscard]] std::vector<double> with_solved_output_layer(const PerceptronShape& shape,
                                                           const Samples& samples,
                                                           std::vector<double> hidden_weights,
                                                           const ColumnBlock& fixed = kNoColumns);

}  // namespace proofmass
