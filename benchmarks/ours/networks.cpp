// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include "ours/tasks.hpp"
#include "proofmass/identify/network/training/trainer.hpp"
#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"
#include "proofmass/numeric/network/perceptron_problem.hpp"
#include "proofmass/numeric/optimise/levenberg_marquardt.hpp"
#include "proofmass/numeric/samples.hpp"

namespace bench::ours {
namespace {

using proofmass::PerceptronShape;
using proofmass::Samples;

constexpr std::size_t kInputs = 3;

Samples as_samples(const NetworkSamples& rows) {
  Samples samples(kInputs, rows.rows);
  for (std::size_t k = 0; k < kInputs; ++k) {
    const std::span<double> column = samples.input(k);
    for (std::size_t row = 0; row < rows.rows; ++row) column[row] = rows.at(row)[k];
  }
  const std::span<double> target = samples.target();
  for (std::size_t row = 0; row < rows.rows; ++row) target[row] = rows.at(row)[kInputs];
  return samples;
}

// Times evaluate(shape, weights, samples), which returns a sum of squares, over all networks given: ns per
// network and sample, and each network's RMSE.
template <typename Evaluate>
Answer time_networks(const Request& request, const Evaluate& evaluate) {
  const PerceptronShape shape{.inputs = kInputs, .hidden = request.hidden};
  const Samples samples = as_samples(read_samples(request));
  const std::vector<Row> networks = read_table(request.starts);
  std::vector<double> rmse(networks.size());
  const auto rows = static_cast<double>(samples.rows());
  Answer answer = measure(request.seconds, [&] {
    for (std::size_t k = 0; k < networks.size(); ++k) {
      rmse[k] = proofmass::root_mean(evaluate(shape, networks[k], samples), samples);
    }
  });
  answer.ns = 1e9 * answer.seconds / (rows * static_cast<double>(networks.size()));
  answer.values = rmse;
  return answer;
}

// Training of all weights with the damping of GSL and Ceres, which rarely tries a point without success.
Answer train_by_gain(const Request& request, const NetworkSamples& rows, const PerceptronShape& shape,
                     const Samples& samples) {
  return contend_training(request, rows, [&](std::span<const double> start, std::size_t epochs) {
    proofmass::PerceptronProblem problem(shape, samples);
    const proofmass::LevenbergMarquardtOptions options{.iterations = epochs, .mu = 1e-3, .mu_max = 1e16};
    const proofmass::LevenbergMarquardtResult result = proofmass::minimise(problem, start, options);
    return Trained{.weights = result.point,
                   .rmse = proofmass::root_mean(result.sum_of_squares, samples),
                   .epochs = result.iterations};
  });
}

}  // namespace

Answer forward(const Request& request) {
  return time_networks(request, [](const PerceptronShape& shape, const Row& weights, const Samples& samples) {
    return proofmass::perceptron_sse(shape, weights, samples);
  });
}

// The kernels of an epoch with one trial, without the solution of its normal equations.
Answer kernels(const Request& request) {
  const PerceptronShape shape{.inputs = kInputs, .hidden = request.hidden};
  proofmass::Matrix jtj(shape.parameters(), shape.parameters());
  std::vector<double> jte(shape.parameters());
  std::optional<proofmass::PerceptronColumns> columns;
  return time_networks(request, [&](const PerceptronShape&, const Row& weights, const Samples& samples) {
    if (!columns) columns.emplace(shape, samples);
    const double sum = proofmass::perceptron_sse(shape, weights, samples, *columns);
    (void)proofmass::perceptron_normal_equations(shape, weights, samples, true, *columns, jtj, jte);
    return sum;
  });
}

// Variants: varpro, which takes the hidden weights of a start and solves for the rest, and lm.
Answer train(const Request& request) {
  const PerceptronShape shape{.inputs = kInputs, .hidden = request.hidden};
  const NetworkSamples rows = read_samples(request);
  const Samples samples = as_samples(rows);
  if (request.variant == "lm-gain") return train_by_gain(request, rows, shape, samples);
  proofmass::TrainingOptions options;
  options.trainer = request.variant == "lm" ? proofmass::Trainer::lm : proofmass::Trainer::varpro;
  const proofmass::NetworkTrainer trainer(shape, samples, nullptr, options);
  return contend_training(request, rows, [&](std::span<const double> start, std::size_t epochs) {
    std::vector<double> weights(start.begin(), start.end());
    if (options.trainer == proofmass::Trainer::varpro) weights.resize(shape.hidden_weights());
    proofmass::TrainingState state = trainer.start(std::move(weights));
    trainer.train(state, epochs, [] { return true; });
    return Trained{.weights = state.weights, .rmse = state.training_rmse, .epochs = state.epochs};
  });
}

}  // namespace bench::ours
