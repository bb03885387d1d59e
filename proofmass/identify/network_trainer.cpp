// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network_trainer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
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
          .stall_window = 10,
          .stall_reduction = 1e-2};
}

// How training goes on from its best point once kicks no longer help: to a minimum.
constexpr std::size_t kPolishWindow = 50;
constexpr double kPolishReduction = 1e-5;
// A kick adds normal numbers of this standard deviation to the hidden weights, of inputs scaled to [-1, 1].
constexpr double kKick = 0.1;
// A kick has helped when training comes to rest at less than this share of the least sum of squares before.
constexpr double kGain = 0.98;

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

TrainingState NetworkTrainer::start(std::vector<double> weights, RandomStream random) const {
  if (weights.size() == shape_.hidden_weights()) {
    weights = with_solved_output_layer(shape_, training_, std::move(weights));
  }
  TrainingState state;
  state.random = random;
  state.polishing = validation_ != nullptr;  // whose rows end the training, without kicks
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

bool NetworkTrainer::go_on(TrainingState& state, double sum_of_squares) const {
  if (options_.trainer != Trainer::varpro || validation_ != nullptr || state.polishing) return false;
  const bool helped = sum_of_squares < kGain * state.settled;
  state.settled = std::min(state.settled, sum_of_squares);
  state.idle_kicks = helped ? 0 : state.idle_kicks + 1;
  state.polishing = state.idle_kicks >= options_.kicks;
  state.point = state.weights;
  state.mu = projected().mu;
  if (state.polishing) return true;
  ++state.kicks;
  for (std::size_t k = 0; k < shape_.hidden_weights(); ++k) state.point[k] += kKick * state.random.normal();
  return true;
}

LevenbergMarquardtOptions NetworkTrainer::settings_for(const TrainingState& state, std::size_t epochs) const {
  LevenbergMarquardtOptions settings = options_.trainer == Trainer::varpro ? projected() : textbook(options_);
  if (state.polishing) {
    settings.stall_window = kPolishWindow;
    settings.stall_reduction = kPolishReduction;
  }
  settings.iterations = epochs;
  settings.mu = state.mu;
  return settings;
}

void NetworkTrainer::take(LevenbergMarquardtResult&& result, TrainingState& state) const {
  state.epochs += result.iterations;
  state.mu = result.mu;
  state.termination = std::move(result.termination);
  state.point = options_.trainer == Trainer::varpro
                    ? with_solved_output_layer(shape_, training_, std::move(result.point))
                    : std::move(result.point);
  const double rmse = root_mean(result.sum_of_squares, training_);
  if (validation_ != nullptr || !(rmse <= state.training_rmse)) return;
  state.training_rmse = rmse;
  state.weights = state.point;
}

void NetworkTrainer::train(TrainingState& state, std::size_t epochs,
                           const std::function<bool()>& keep_going) const {
  if (state.finished) return;
  SeparablePerceptron hidden(shape_, training_);
  PerceptronProblem all(shape_, training_);
  const bool separable = options_.trainer == Trainer::varpro;
  SumOfSquares& problem = separable ? static_cast<SumOfSquares&>(hidden) : all;
  std::optional<EarlyStopping> early;
  if (validation_ != nullptr) early.emplace(shape_, *validation_, options_.validation_failures, state);
  bool stopped_early = false;
  const auto observe = [&](std::size_t, std::span<const double> point, double sum_of_squares) {
    const double rmse = root_mean(sum_of_squares, training_);
    state.training_curve.push_back(std::min(rmse, state.training_curve.back()));
    if (early) {
      std::vector<double> weights(point.begin(), point.end());
      const auto& output = hidden.output_weights();
      if (separable) weights.insert(weights.end(), output.begin(), output.end());
      stopped_early = !early->improve(std::move(weights), rmse);
    }
    return !stopped_early && keep_going();
  };

  for (std::size_t left = epochs; left > 0 && !state.finished;) {
    const std::span<const double> from(state.point.data(), problem.parameters());
    LevenbergMarquardtResult result = minimise(problem, from, settings_for(state, left), observe);
    left -= std::min(left, std::max<std::size_t>(result.iterations, 1));
    const double sum_of_squares = result.sum_of_squares;
    take(std::move(result), state);
    if (state.termination.cause == Cause::iteration_limit) return;
    state.finished = state.termination.cause != Cause::stalled || !go_on(state, sum_of_squares);
  }
  if (!state.finished) {
    state.termination = {Cause::iteration_limit, "the epochs allowed are spent"};
  } else if (stopped_early) {
    state.termination.reason =
        fmt::format("validation error did not improve in {} epochs", options_.validation_failures);
  } else if (state.kicks > 0 && state.termination.cause != Cause::stopped) {
    state.termination.reason += fmt::format(", kicks ({}) having ceased to help", state.kicks);
  }
}

double NetworkTrainer::merit(const TrainingState& state) const noexcept {
  const double rmse = validation_ != nullptr ? state.validation_rmse : state.training_rmse;
  return std::isnan(rmse) ? std::numeric_limits<double>::infinity() : rmse;
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
