// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/paper/reproduce.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "proofmass/core/step_progress.hpp"
#include "proofmass/core/version.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/study/compare.hpp"
#include "proofmass/study/paper/reproduce_entries.hpp"
#include "proofmass/study/paper/swarm_gain.hpp"
#include "proofmass/study/truth.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kSmallest = 3;  // hidden units: sqrt(3 + 1) + 1 ... sqrt(3 + 1) + 10
constexpr std::size_t kLargest = 12;
constexpr double kFineSigma = 1e-6;  // g; noise at which training, not noise, decides

std::vector<HiddenSizeScore> hidden_sizes(const Dataset& record, const ReproduceOptions& budget,
                                          double& iterations, Progress& progress) {
  StepProgress steps(progress, "Table 1", (kLargest - kSmallest + 1) * budget.size_repeats);
  std::vector<HiddenSizeScore> sizes;
  for (std::size_t hidden = kSmallest; hidden <= kLargest; ++hidden) {
    HiddenSizeScore score{.hidden = hidden, .training_mse = {}};
    Entry bp = textbook_bp(budget);
    network_options(bp.method)->hidden = hidden;
    for (std::size_t r = 0; r < budget.size_repeats; ++r, ++bp.options.seed) {
      const Identification result = identify(record, bp.method, bp.options, steps).identification;
      score.training_mse.push_back(result.train->mse);
      if (r == 0) iterations += static_cast<double>(result.diagnostics.iterations.value_or(0));
      steps.step();
    }
    sizes.push_back(std::move(score));
  }
  return sizes;
}

// Compares entry by entry, so that progress and interruption come between.
Comparison compare_all(const Dataset& record, const std::vector<Entry>& entries, std::size_t repeats,
                       const SimulationPlan& twin, std::string_view table, Progress& progress) {
  StepProgress steps(progress, table, entries.size());
  Comparison all;
  for (const Entry& one : entries) {
    Comparison part = compare(record, std::span(&one, 1), repeats, steps);
    std::vector<Contestant> contestants = std::exchange(all.contestants, {});
    contestants.push_back(std::move(part.contestants.front()));
    all = std::move(part);
    all.contestants = std::move(contestants);
    steps.step();
  }
  score_truth(all, record, twin);
  return all;
}

std::vector<SwarmGain> gains_of(const SimulationPlan& twin, const ReproduceOptions& budget,
                                Progress& progress) {
  StepProgress steps(progress, "BP against PSO-BP", 4 * budget.gain_seeds);
  std::vector<SwarmGain> gains;
  for (const double sigma : {twin.noise.sigma, kFineSigma}) {
    for (const Entry& swarm : {paper_swarm(budget), our_swarm(budget)}) {
      gains.push_back(measure_gain(twin, sigma, swarm, budget, steps));
    }
  }
  return gains;
}

// Error on training, validation and test rows by epoch. Training never looks at the last two: the second
// run takes the same path as the first, and only watches other rows.
std::vector<Curve> training_curves(const Dataset& record, const Run& run, Entry who,
                                   std::vector<Curve>& swarm, Progress& progress) {
  TrainingOptions& training_options = network_options(who.method)->training;
  training_options.validation_failures = training_options.epochs + 1;
  const Dataset training = record.select(run.split.training);
  std::vector<Curve> curves;
  for (const auto& [name, rows] :
       {std::pair("validation", &run.split.validation), {"test", &run.split.test}}) {
    const Identification result = fit(who.method, training, record.select(*rows), who.options, progress);
    swarm.clear();
    for (const Curve& curve : result.history) {
      if (curve.name == "training_rmse" && curves.empty()) curves.push_back({"training", curve.values});
      if (curve.name == "validation_rmse") curves.push_back({name, curve.values});
      if (curve.name.starts_with("swarm")) swarm.push_back(curve);
    }
  }
  return curves;
}

void add_figures(Reproduction& made, const Dataset& record, const ReproduceOptions& budget,
                 Progress& progress) {
  StepProgress steps(progress, "Figures", 2);
  // The paper's swarm stops early: its split has validation rows.
  const Run& run = made.networks.contestants.at(1).runs.front();
  std::vector<Curve> none;
  made.bp_training = training_curves(record, run, textbook_bp(budget), none, steps);
  steps.step();
  made.swarm_training = training_curves(record, run, paper_swarm(budget), made.swarm, steps);
  steps.step();
  const Dataset test = record.select(run.split.test);
  const double unit = 1.0 / record.output_unit.to_canonical;
  const auto declared = [unit](std::vector<double> values) {
    for (double& value : values) value *= unit;
    return values;
  };
  made.measured = declared(test.output);
  for (const Contestant& contestant : made.networks.contestants) {
    made.predicted.push_back(
        {contestant.method, declared(predict(contestant.runs.front().identification, test))});
  }
}

}  // namespace

ReproduceOptions quick_reproduction() {
  ReproduceOptions options;
  options.size_repeats = 1;
  options.repeats = 1;
  options.gain_seeds = 2;
  return options;
}

Reproduction reproduce(SimulationPlan twin, const ReproduceOptions& options, Progress& progress) {
  twin.output_unit = find_unit("m/s^2").value();
  const Dataset record = simulate(twin, twin.rows, options.seed);
  Reproduction made;
  made.twin = twin.source;
  made.rows = twin.rows;
  made.seed = options.seed;
  made.sigma = twin.noise.sigma;
  const double declared_sigma = twin.noise.sigma / record.output_unit.to_canonical;
  made.noise_mse = declared_sigma * declared_sigma;
  made.truth = twin.truth();
  made.unit = record.output_unit.symbol;
  made.sizes = hidden_sizes(record, options, made.search_iterations, progress);
  made.coefficients = compare_all(record, table_2_entries(options), 1, twin, "Table 2", progress);
  const std::vector<Entry> networks{textbook_bp(options), paper_swarm(options), multistart(options),
                                    our_swarm(options)};
  made.networks = compare_all(record, networks, options.repeats, twin, "Table 3", progress);
  const auto iterations = [&made](std::size_t k) {
    return static_cast<double>(
        made.networks.contestants[k].runs.front().identification.diagnostics.iterations.value_or(0));
  };
  made.search_iterations += iterations(0);
  made.swarm_iterations = iterations(1);
  made.gains = gains_of(twin, options, progress);
  add_figures(made, record, options, progress);
  return made;
}

}  // namespace proofmass
