// SPDX-License-Identifier: Apache-2.0
// What one call of a trainer does with a state: minimisations one after the other, each epoch on record.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "proofmass/identify/network/training/trainer.hpp"
#include "proofmass/numeric/network/perceptron_problem.hpp"
#include "proofmass/numeric/network/variable_projection.hpp"
#include "proofmass/numeric/optimise/levenberg_marquardt.hpp"

namespace proofmass {

// Keeps references to all it is given. `validation` may be null.
class NetworkDescent {
 public:
  NetworkDescent(const PerceptronShape& shape, const Samples& training, const Samples* validation,
                 const ColumnBlock& fixed, const TrainingOptions& options, TrainingState& state,
                 const std::function<bool()>& keep_going);

  // From where the state stands; its curves and, with validation rows, its best weights follow.
  LevenbergMarquardtResult run(const LevenbergMarquardtOptions& settings);
  // Whether the validation rows have ended it.
  [[nodiscard]] bool stopped_early() const noexcept { return stopped_early_; }

 private:
  bool observe(std::span<const double> point, double rmse);
  // Takes the weights if their validation error is the least so far; false when it has not been for too long.
  bool improve(std::vector<double> weights, double training_rmse);

  const PerceptronShape& shape_;
  const Samples& training_;
  const Samples* validation_;
  std::size_t patience_;
  TrainingState& state_;
  const std::function<bool()>& keep_going_;
  std::optional<SeparablePerceptron> hidden_;  // by variable projection
  std::optional<PerceptronProblem> all_;       // by all weights
  bool stopped_early_ = false;
};

}  // namespace proofmass
