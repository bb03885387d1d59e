// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>
#include <vector>

#include "proofmass/identify/network/training/descent_internal.hpp"
#include "proofmass/identify/network/training/weight_path.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"

namespace proofmass {

NetworkDescent::NetworkDescent(const PerceptronShape& shape, const Samples& training,
                               const Samples* validation, const ColumnBlock& fixed,
                               const TrainingOptions& options, TrainingState& state,
                               const std::function<bool()>& keep_going)
    : shape_(shape),
      training_(training),
      validation_(validation),
      patience_(options.validation_failures),
      state_(state),
      keep_going_(keep_going) {
  if (options.trainer == Trainer::varpro) {
    hidden_.emplace(shape, training, fixed);
  } else {
    all_.emplace(shape, training);
  }
}

LevenbergMarquardtResult NetworkDescent::run(const LevenbergMarquardtOptions& settings) {
  SumOfSquares& problem = hidden_ ? static_cast<SumOfSquares&>(*hidden_) : *all_;
  const std::span<const double> from(state_.point.data(), problem.parameters());
  return minimise(problem, from, settings,
                  [this](std::size_t, std::span<const double> point, double sum_of_squares) {
                    return observe(point, root_mean(sum_of_squares, training_));
                  });
}

bool NetworkDescent::observe(std::span<const double> point, double rmse) {
  state_.training_curve.push_back(std::min(rmse, state_.training_curve.back()));
  const std::span<const double> output =
      hidden_ ? std::span<const double>(hidden_->output_weights()) : std::span<const double>();
  add_to_path(state_.path, state_.training_curve.size() - 1, rmse, point, output);
  if (validation_ != nullptr) {
    std::vector<double> weights(point.begin(), point.end());
    weights.insert(weights.end(), output.begin(), output.end());
    stopped_early_ = !improve(std::move(weights), rmse);
  }
  return !stopped_early_ && keep_going_();
}

bool NetworkDescent::improve(std::vector<double> weights, double training_rmse) {
  const double rmse = root_mean(perceptron_sse(shape_, weights, *validation_), *validation_);
  state_.validation_curve.push_back(rmse);
  if (!(rmse < state_.validation_rmse)) return ++state_.failures < patience_;
  state_.validation_rmse = rmse;
  state_.training_rmse = training_rmse;
  state_.weights = std::move(weights);
  state_.failures = 0;
  return true;
}

}  // namespace proofmass
