// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network_trainer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include "proofmass/numeric/levenberg_marquardt.hpp"
#include "proofmass/numeric/perceptron_kernels.hpp"
#include "proofmass/numeric/perceptron_problem.hpp"
#include "proofmass/numeric/variable_projection.hpp"

namespace proofmass {
namespace {

double root_mean(double sum_of_squares, const Samples& samples) {
  return std::sqrt(sum_of_squares / static_cast<double>(samples.rows()));
}

LevenbergMarquardtOptions textbook(const NetworkOptions& options) {
  return {.damping = Damping::multiplicative,
          .scaled = false,
          .mu = options.mu,
          .decrease = options.mu_decrease,
          .increase = options.mu_increase,
          .mu_max = options.mu_max,
          .minimum_gradient = options.minimum_gradient};
}

LevenbergMarquardtOptions projected() {
  return {.damping = Damping::gain_ratio,
          .scaled = true,
          .geodesic_acceleration = true,
          .mu = 0.1,
          .mu_max = 1e16,
          .stall_window = 100,
          .stall_reduction = 1e-4};
}

// Stops training when the validation error has not improved for some epochs, and remembers the best weights.
class EarlyStopping {
 public:
  EarlyStopping(const PerceptronShape& shape, const Samples& validation, std::size_t patience,
                TrainingState& state)
      : shape_(shape), validation_(validation), patience_(patience), state_(state) {}

  bool improve(std::vector<double> weights, double training_rmse) {
    const double rmse = root_mean(perceptron_sse(shape_, weights, validation_), validation_);
    state_.validation_curve.push_back(rmse);
    if (rmse < state_.validation_rmse) {
      state_.validation_rmse = rmse;
      state_.training_rmse = training_rmse;
      state_.weights = std::move(weights);
      state_.failures = 0;
      return true;
    }
    return ++state_.failures < patience_;
  }

 private:
  const PerceptronShape& shape_;
  const Samples& validation_;
  std::size_t patience_;
  TrainingState& state_;
};

}  // namespace

NetworkTrainer::NetworkTrainer(const PerceptronShape& shape, const Samples& training,
                               const Samples* validation, const NetworkOptions& options)
    : shape_(shape), training_(training), validation_(validation), options_(options) {}

TrainingState NetworkTrainer::start(std::vector<double> weights) const {
  if (weights.size() == shape_.hidden_weights()) {
    weights = with_solved_output_layer(shape_, training_, std::move(weights));
  }
  TrainingState state;
  state.weights = std::move(weights);
  state.point = state.weights;
  state.training_rmse = root_mean(perceptron_sse(shape_, state.weights, training_), training_);
  state.training_curve = {state.training_rmse};
  state.mu = options_.trainer == Trainer::lm ? options_.mu : projected().mu;
  if (validation_ != nullptr) {
    state.validation_rmse = root_mean(perceptron_sse(shape_, state.weights, *validation_), *validation_);
    state.validation_curve = {state.validation_rmse};
  }
  return state;
}

void NetworkTrainer::train(TrainingState& state, std::size_t epochs,
                           const std::function<bool()>& keep_going) const {
  if (state.finished) return;
  const bool separable = options_.trainer == Trainer::varpro;
  LevenbergMarquardtOptions settings = separable ? projected() : textbook(options_);
  settings.iterations = epochs;
  settings.mu = state.mu;

  SeparablePerceptron hidden(shape_, training_);
  PerceptronProblem all(shape_, training_);
  const auto complete = [&](std::span<const double> point) {
    std::vector<double> weights(point.begin(), point.end());
    if (separable)
      weights.insert(weights.end(), hidden.output_weights().begin(), hidden.output_weights().end());
    return weights;
  };
  std::unique_ptr<EarlyStopping> early;
  if (validation_ != nullptr) {
    early = std::make_unique<EarlyStopping>(shape_, *validation_, options_.validation_failures, state);
  }
  bool stopped_early = false;
  const auto observe = [&](std::size_t, std::span<const double> point, double sum_of_squares) {
    state.training_curve.push_back(root_mean(sum_of_squares, training_));
    stopped_early = early && !early->improve(complete(point), state.training_curve.back());
    return !stopped_early && keep_going();
  };

  const std::span<const double> from(state.point.data(), separable ? hidden.parameters() : all.parameters());
  SumOfSquares& problem = separable ? static_cast<SumOfSquares&>(hidden) : all;
  const LevenbergMarquardtResult result = minimise(problem, from, settings, observe);
  state.epochs += result.iterations;
  state.mu = result.mu;
  state.termination = result.termination;
  state.finished = stopped_early || result.termination.cause != Cause::iteration_limit;
  if (stopped_early) {
    state.termination.reason =
        fmt::format("validation error did not improve in {} epochs", options_.validation_failures);
  }
  state.point = separable ? with_solved_output_layer(shape_, training_, result.point) : result.point;
  if (early) return;
  state.training_rmse = root_mean(result.sum_of_squares, training_);
  state.weights = state.point;
}

double NetworkTrainer::merit(const TrainingState& state) const noexcept {
  return validation_ != nullptr ? state.validation_rmse : state.training_rmse;
}

std::vector<double> with_solved_output_layer(const PerceptronShape& shape, const Samples& samples,
                                             std::vector<double> hidden_weights) {
  SeparablePerceptron problem(shape, samples);
  (void)problem.evaluate(hidden_weights);
  hidden_weights.insert(hidden_weights.end(), problem.output_weights().begin(),
                        problem.output_weights().end());
  return hidden_weights;
}

}  // namespace proofmass
