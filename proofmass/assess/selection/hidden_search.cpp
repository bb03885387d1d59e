// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/selection/hidden_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "proofmass/assess/metrics.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/core/step_progress.hpp"
#include "proofmass/numeric/network/perceptron.hpp"
#include "proofmass/numeric/parallel.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kSteps = 10;  // alpha

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double standard_deviation(const std::vector<double>& values) {
  const double centre = mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - centre) * (value - centre);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

// The rows of one repeat: what trains, and what is set aside.
struct Parts {
  Dataset training, validation;
};

// With the method's network as it is, on the rows set aside.
double validation_rmse(const Parts& parts, const Method& method, const IdentifyOptions& options,
                       Progress& progress) {
  const Dataset none = parts.validation.select(std::vector<std::size_t>{});
  const bool early = network_options(method)->early_stopping;
  const Identification trained =
      fit(method, parts.training, early ? parts.validation : none, options, progress);
  const double to_declared = 1.0 / parts.validation.output_unit.to_canonical;
  return score(parts.validation.output, predict(trained, parts.validation), to_declared).rmse;
}

// Sizes that the rows of a repeat can train; the smallest one at least, for the method to refuse.
std::vector<HiddenTrial> trainable(const Parts& parts, std::size_t repeats) {
  const std::size_t inputs = parts.training.axes().size();
  std::vector<HiddenTrial> trials;
  for (const std::size_t hidden : hidden_sizes(inputs)) {
    const std::size_t weights = PerceptronShape{inputs, hidden}.parameters();
    if (!trials.empty() && weights >= parts.training.rows()) break;
    trials.push_back({.hidden = hidden, .weights = weights, .validation_rmse = std::vector<double>(repeats)});
  }
  return trials;
}

}  // namespace

std::vector<std::size_t> hidden_sizes(std::size_t inputs) {
  const auto root = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(inputs + 1))));
  std::vector<std::size_t> sizes(kSteps);
  std::iota(sizes.begin(), sizes.end(), root + 1);
  return sizes;
}

std::size_t choose_hidden(std::span<const HiddenTrial> trials) {
  const auto best = std::min_element(trials.begin(), trials.end(),
                                     [](const auto& a, const auto& b) { return a.mean < b.mean; });
  const double error = best->spread / std::sqrt(static_cast<double>(best->validation_rmse.size()));
  const auto chosen = std::find_if(trials.begin(), trials.end(), [&](const HiddenTrial& trial) {
    return trial.mean <= best->mean + error;
  });
  return static_cast<std::size_t>(chosen - trials.begin());
}

std::vector<HiddenTrial> try_hidden_sizes(const Dataset& rows, const Method& method,
                                          const IdentifyOptions& options, std::span<const Split> splits,
                                          Progress& progress) {
  if (network_options(method) == nullptr) {
    throw usage_error(message("{} has no network of a size to choose", info(method).name));
  }
  const std::size_t repeats = splits.size();
  if (repeats < 2)
    throw usage_error(message("a search needs at least 2 repeats of each size, got {}", repeats));
  std::vector<Parts> parts;
  for (const Split& split : splits)
    parts.push_back({rows.select(split.training), rows.select(split.validation)});
  std::vector<HiddenTrial> trials = trainable(parts.front(), repeats);
  StepProgress steps(progress, "hidden sizes", trials.size() * repeats);
  // From the largest down: the long ones must not come last, when other threads have nothing left to do.
  parallel_for(trials.size() * repeats, [&](std::size_t k) {
    steps.require_going();  // preparing the rows of all trials that are left would take long
    HiddenTrial& trial = trials[trials.size() - 1 - k / repeats];
    const std::size_t r = k % repeats;
    Method sized = method;
    set_hidden(sized, trial.hidden);
    IdentifyOptions seeded = options;
    seeded.seed += r;
    trial.validation_rmse[r] = validation_rmse(parts[r], sized, seeded, steps);
    steps.step();
  });
  for (HiddenTrial& trial : trials) {
    trial.mean = mean(trial.validation_rmse);
    trial.best = *std::min_element(trial.validation_rmse.begin(), trial.validation_rmse.end());
    trial.spread = standard_deviation(trial.validation_rmse);
  }
  trials[choose_hidden(trials)].chosen = true;
  return trials;
}

}  // namespace proofmass
