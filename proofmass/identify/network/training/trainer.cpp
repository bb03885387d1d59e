// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/training/trainer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "proofmass/identify/model/ending_of.hpp"
#include "proofmass/identify/network/training/descent_internal.hpp"
#include "proofmass/identify/network/training/weight_path.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"
#include "proofmass/numeric/network/variable_projection.hpp"
#include "proofmass/numeric/optimise/levenberg_marquardt.hpp"

namespace proofmass {
namespace {

LevenbergMarquardtOptions textbook(const TrainingOptions& options) {
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
          .mu_max = 1e16};
}

// Until what is left to gain is not worth the epochs.
LevenbergMarquardtOptions projected_until_rest() {
  LevenbergMarquardtOptions settings = projected();
  settings.stall_window = 6;
  settings.stall_reduction = 1e-2;
  return settings;
}

LevenbergMarquardtOptions projected_until_minimum() {
  LevenbergMarquardtOptions settings = projected();
  settings.stall_window = 50;
  settings.stall_reduction = 1e-5;
  return settings;
}

// A perturbation adds normal numbers of this standard deviation to the hidden weights, of inputs scaled to
// [-1, 1]: enough to leave the valley, little enough to keep what has been learnt.
constexpr double kPerturbation = 0.03;
// A perturbation has helped when training comes to rest at less than this fraction of the least sum of
// squares before.
constexpr double kGain = 0.8;
// Ratio of a network's sum of squares to that of the projection beyond which the latter is wrong.
constexpr double kAgreement = 1.1;

void mention_perturbations(TrainingState& state) {
  if (state.perturbations == 0 || state.termination.cause == Cause::stopped) return;
  state.termination.remarks.push_back(
      {.event = Event::weights_perturbed,
       .figures = {{"count", state.perturbations}, {"idle", state.idle_perturbations}}});
}

}  // namespace

NetworkTrainer::NetworkTrainer(const PerceptronShape& shape, const Samples& training,
                               const Samples* validation, const TrainingOptions& options)
    : shape_(shape), training_(training), validation_(validation), fixed_(kNoColumns), options_(options) {}

NetworkTrainer::NetworkTrainer(const PerceptronShape& shape, const Samples& training,
                               const ColumnBlock& fixed, const TrainingOptions& options)
    : shape_(shape), training_(training), validation_(nullptr), fixed_(fixed), options_(options) {
  if (options.trainer != Trainer::varpro) {
    throw std::invalid_argument("further columns are trained by variable projection alone");
  }
}

TrainingState NetworkTrainer::start(std::vector<double> weights, RandomStream random) const {
  if (weights.size() == shape_.hidden_weights()) {
    weights = with_solved_output_layer(shape_, training_, std::move(weights), fixed_);
  }
  TrainingState state;
  state.random = random;
  state.weights = std::move(weights);
  state.point = state.weights;
  state.training_rmse = root_mean(sum_of_squares(state.weights), training_);
  state.training_curve = {state.training_rmse};
  add_to_path(state.path, 0, state.training_rmse, state.weights);
  state.rests_at_minimum = options_.trainer == Trainer::varpro;
  state.mu = options_.trainer == Trainer::lm ? options_.mu : projected().mu;
  if (validation_ != nullptr) {
    state.validation_rmse = root_mean(perceptron_sse(shape_, state.weights, *validation_), *validation_);
    state.validation_curve = {state.validation_rmse};
  }
  return state;
}

double NetworkTrainer::sum_of_squares(std::span<const double> weights) const {
  if (fixed_.columns() == 0) return perceptron_sse(shape_, weights, training_);
  SeparablePerceptron problem(shape_, training_, fixed_);
  return problem.evaluate(weights.first(shape_.hidden_weights()));
}

bool NetworkTrainer::go_on(TrainingState& state, double sum_of_squares) const {
  if (options_.trainer != Trainer::varpro || validation_ != nullptr) return false;
  const bool helped = sum_of_squares < kGain * state.settled;
  state.settled = std::min(state.settled, sum_of_squares);
  state.idle_perturbations = helped ? 0 : state.idle_perturbations + 1;
  state.point = state.weights;
  state.mu = projected().mu;
  if (state.idle_perturbations >= options_.perturbations) return false;
  ++state.perturbations;
  for (std::size_t k = 0; k < shape_.hidden_weights(); ++k)
    state.point[k] += kPerturbation * state.random.normal();
  return true;
}

LevenbergMarquardtOptions NetworkTrainer::settings(const TrainingState& state) const {
  // Validation rows end the training themselves.
  LevenbergMarquardtOptions settings = options_.trainer == Trainer::lm ? textbook(options_)
                                       : validation_ != nullptr        ? projected_until_minimum()
                                                                       : projected_until_rest();
  settings.mu = state.mu;
  return settings;
}

double NetworkTrainer::take(LevenbergMarquardtResult&& result, TrainingState& state) const {
  state.epochs += result.iterations;
  state.mu = result.mu;
  state.termination = std::move(result.termination);
  state.point = options_.trainer == Trainer::varpro
                    ? with_solved_output_layer(shape_, training_, std::move(result.point), fixed_)
                    : std::move(result.point);
  double sum = result.sum_of_squares;
  // Projection finds the sum from products, which cancel where the output layer is ill determined; the
  // outputs of the network tell.
  if (const double actual = sum_of_squares(state.point); !(actual <= kAgreement * sum)) sum = actual;
  const double rmse = root_mean(sum, training_);
  if (validation_ != nullptr) return sum;
  if (rmse <= state.training_rmse) {
    state.training_rmse = rmse;
    state.weights = state.point;
  }
  if (sum == result.sum_of_squares) return sum;
  for (double& value : state.training_curve) value = std::max(value, state.training_rmse);
  return sum;
}

void NetworkTrainer::train(TrainingState& state, std::size_t epochs,
                           const std::function<bool()>& keep_going) const {
  if (state.finished) return;
  NetworkDescent descent(shape_, training_, validation_, fixed_, options_, state, keep_going);
  for (std::size_t left = epochs; left > 0 && !state.finished;) {
    LevenbergMarquardtOptions settings = this->settings(state);
    settings.iterations = left;
    LevenbergMarquardtResult result = descent.run(settings);
    left -= std::min(left, std::max<std::size_t>(result.iterations, 1));
    const double reached = take(std::move(result), state);
    if (state.termination.cause == Cause::iteration_limit) return;
    state.finished = state.termination.cause != Cause::stalled || !go_on(state, reached);
  }
  if (!state.finished) {
    state.termination = ended(Cause::iteration_limit, Event::epochs_spent);
  } else if (descent.stopped_early()) {
    state.termination.remarks = {
        {.event = Event::validation_stalled, .figures = {{"epochs", options_.validation_failures}}}};
  } else {
    mention_perturbations(state);
  }
}

void NetworkTrainer::polish(TrainingState& state, std::size_t epochs,
                            const std::function<bool()>& keep_going) const {
  const bool rests = state.finished && state.termination.cause == Cause::stalled;
  if (options_.trainer != Trainer::varpro || validation_ != nullptr || !rests || epochs == 0) return;
  NetworkDescent descent(shape_, training_, validation_, fixed_, options_, state, keep_going);
  LevenbergMarquardtOptions settings = projected_until_minimum();
  settings.iterations = epochs;
  state.point = state.weights;
  take(descent.run(settings), state);
  mention_perturbations(state);
}

double NetworkTrainer::merit(const TrainingState& state) const noexcept {
  const double rmse = validation_ != nullptr ? state.validation_rmse : state.training_rmse;
  return std::isnan(rmse) ? std::numeric_limits<double>::infinity() : rmse;
}

Ending training_end(const TrainingState& state) {
  const Termination& end = state.termination;
  if (end.cause != Cause::stalled || !state.rests_at_minimum) return ending_of(end);
  return {.status = EndingStatus::converged,
          .parts = {{.code = EndingCode::nothing_left, .parts = ending_parts(end)}}};
}

std::vector<double> with_solved_output_layer(const PerceptronShape& shape, const Samples& samples,
                                             std::vector<double> hidden_weights, const ColumnBlock& fixed) {
  SeparablePerceptron problem(shape, samples, fixed);
  (void)problem.evaluate(hidden_weights);
  hidden_weights.insert(hidden_weights.end(), problem.output_weights().begin(),
                        problem.output_weights().end());
  return hidden_weights;
}

}  // namespace proofmass
