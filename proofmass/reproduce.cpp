// SPDX-License-Identifier: Apache-2.0
#include "proofmass/reproduce.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "proofmass/compare.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/report/version.hpp"
#include "proofmass/truth.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kSmallest = 3;  // hidden units: sqrt(3 + 1) + 1 ... sqrt(3 + 1) + 10
constexpr std::size_t kLargest = 12;
constexpr double kFineSigma = 1e-6;  // g; noise at which training, not noise, decides

// Counts the steps of a table under its name; what a method says of itself inside a step is kept back.
class Steps final : public Progress {
 public:
  Steps(Progress& outer, std::string_view table, std::size_t total)
      : outer_(outer), table_(table), total_(total) {
    outer_.update(table_, 0, total_);
  }
  void update(std::string_view, std::size_t, std::size_t) override {}
  [[nodiscard]] bool cancelled() const noexcept override { return outer_.cancelled(); }
  void step() {
    if (cancelled()) throw Error(ErrorKind::interrupted, "interrupted");
    outer_.update(table_, ++done_, total_);
  }

 private:
  Progress& outer_;
  std::string_view table_;
  std::size_t total_;
  std::size_t done_ = 0;
};

Entry entry(std::string name, std::string_view method, std::string_view terms,
            const ReproduceOptions& budget) {
  Entry made{.name = std::move(name), .method = &find_method(method), .options = {}, .split = {}};
  made.options.terms = parse_terms(terms);
  made.options.seed = budget.seed;
  made.options.network.epochs = budget.refined_epochs;
  return made;
}

Entry textbook_bp(const ReproduceOptions& budget) {
  Entry made = entry("BP", "bp", "paper", budget);
  made.options.network.trainer = Trainer::lm;
  made.options.network.epochs = budget.epochs;
  return made;
}

Entry paper_swarm(const ReproduceOptions& budget) {
  Entry made = entry("PSO-BP, paper", "pso-bp", "paper", budget);
  apply_paper_preset(made.options, made.split);
  made.options.network.epochs = budget.epochs;
  made.options.swarm.particles = budget.particles;
  made.options.swarm.iterations = budget.generations;
  made.options.swarm.fitness_epochs = budget.fitness_epochs;
  return made;
}

// The same epochs as the paper's swarm spends, on random starts.
Entry multistart(const ReproduceOptions& budget) {
  Entry made = paper_swarm(budget);
  made.name = "multistart BP";
  made.method = &find_method("bp");
  made.options.network.starts = budget.particles * (budget.generations + 1);
  made.options.network.start_epochs = budget.fitness_epochs;
  return made;
}

Entry our_swarm(const ReproduceOptions& budget) { return entry("PSO-BP, ours", "pso-bp", "full", budget); }

std::vector<HiddenSizeScore> hidden_sizes(const Dataset& record, const ReproduceOptions& budget,
                                          double& epochs, Progress& progress) {
  Steps steps(progress, "Table 1", (kLargest - kSmallest + 1) * budget.size_repeats);
  std::vector<HiddenSizeScore> sizes;
  for (std::size_t hidden = kSmallest; hidden <= kLargest; ++hidden) {
    HiddenSizeScore score{.hidden = hidden, .training_mse = {}};
    Entry bp = textbook_bp(budget);
    bp.options.network.hidden = hidden;
    for (std::size_t r = 0; r < budget.size_repeats; ++r, ++bp.options.seed) {
      const Identification result = run(record, *bp.method, bp.options, bp.split, steps);
      score.training_mse.push_back(result.train->mse);
      if (r == 0) epochs += static_cast<double>(result.diagnostics.training_epochs.value_or(0));
      steps.step();
    }
    sizes.push_back(std::move(score));
  }
  return sizes;
}

// Compares entry by entry, so that progress and interruption come between.
Comparison compare_all(const Dataset& record, const std::vector<Entry>& entries, std::size_t repeats,
                       const SimulationPlan& twin, std::string_view table, Progress& progress) {
  Steps steps(progress, table, entries.size());
  Comparison all;
  for (const Entry& one : entries) {
    Comparison part = compare(record, std::span(&one, 1), repeats, steps);
    std::vector<Contestant> contestants = std::exchange(all.contestants, {});
    contestants.push_back(std::move(part.contestants.front()));
    for (Identification& result : contestants.back().runs) {
      result.provenance.version = version();
      result.provenance.input = record.source;
    }
    all = std::move(part);
    all.contestants = std::move(contestants);
    steps.step();
  }
  score_truth(all, record, entries, twin);
  return all;
}

std::vector<Entry> table_2(const ReproduceOptions& budget) {
  return {entry("LSM, 8 terms", "ols", "K0,Ki,Kii,Kio,Kip,Kop,Ko,Kp", budget),
          entry("GMDH", "gmdh", "full", budget),
          paper_swarm(budget),
          our_swarm(budget),
          entry("LSM, 15 terms", "ols", "paper", budget),
          entry("LSM, 21 terms", "ols", "full", budget),
          entry("hybrid", "hybrid", "full", budget)};
}

// BP and PSO-BP on records of one noise, one a seed.
SwarmGain gain_of(SimulationPlan plan, double sigma, const Entry& swarm, const ReproduceOptions& budget,
                  Steps& steps) {
  plan.noise.sigma = sigma;
  SwarmGain gain{.sigma = sigma, .preset = swarm.name, .bp_mse = {}, .swarm_mse = {}};
  const auto count = static_cast<double>(budget.gain_seeds);
  const auto score = [&](Entry who, const Dataset& record, std::uint64_t seed, double& epochs) {
    who.options.seed = seed;
    const Identification result = run(record, *who.method, who.options, who.split, steps);
    epochs += static_cast<double>(result.diagnostics.training_epochs.value_or(0)) / count;
    return result.test->mse;
  };
  for (std::size_t k = 0; k < budget.gain_seeds; ++k) {
    const std::uint64_t seed = budget.seed + k;
    const Dataset record = simulate(plan, plan.rows, seed);
    gain.bp_mse.push_back(score(textbook_bp(budget), record, seed, gain.bp_epochs));
    gain.swarm_mse.push_back(score(swarm, record, seed, gain.swarm_epochs));
    steps.step();
  }
  return gain;
}

std::vector<SwarmGain> gains_of(const SimulationPlan& twin, const ReproduceOptions& budget,
                                Progress& progress) {
  Steps steps(progress, "BP against PSO-BP", 4 * budget.gain_seeds);
  std::vector<SwarmGain> gains;
  for (const double sigma : {twin.noise.sigma, kFineSigma}) {
    for (const Entry& swarm : {paper_swarm(budget), our_swarm(budget)}) {
      gains.push_back(gain_of(twin, sigma, swarm, budget, steps));
    }
  }
  return gains;
}

// Error on training, validation and test rows by epoch. Training never looks at the last two: the second
// run takes the same path as the first, and only watches other rows.
std::vector<Curve> training_curves(const Dataset& record, Entry who, std::vector<Curve>& swarm,
                                   Progress& progress) {
  who.split.early_stopping = true;
  who.options.network.validation_failures = who.options.network.epochs + 1;
  const Split split = split_rows(record.rows(), who.split, who.options.seed);
  const Dataset training = record.select(split.training);
  std::vector<Curve> curves;
  for (const auto& [name, rows] : {std::pair("validation", &split.validation), {"test", &split.test}}) {
    const Identification result = who.method->identify(training, record.select(*rows), who.options, progress);
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
  Steps steps(progress, "Figures", 2);
  std::vector<Curve> none;
  made.bp_training = training_curves(record, textbook_bp(budget), none, steps);
  steps.step();
  made.swarm_training = training_curves(record, paper_swarm(budget), made.swarm, steps);
  steps.step();
  const Dataset test = record.select(split_rows(record.rows(), {}, budget.seed).test);
  const double unit = 1.0 / record.output_unit.to_canonical;
  const auto declared = [unit](std::vector<double> values) {
    for (double& value : values) value *= unit;
    return values;
  };
  made.measured = declared(test.output);
  for (const Contestant& contestant : made.networks.contestants) {
    made.predicted.push_back({contestant.method, declared(predict(contestant.runs.front(), test))});
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
  made.sizes = hidden_sizes(record, options, made.search_epochs, progress);
  made.coefficients = compare_all(record, table_2(options), 1, twin, "Table 2", progress);
  const std::vector<Entry> networks{textbook_bp(options), paper_swarm(options), multistart(options),
                                    our_swarm(options)};
  made.networks = compare_all(record, networks, options.repeats, twin, "Table 3", progress);
  const auto epochs = [&made](std::size_t k) {
    return static_cast<double>(
        made.networks.contestants[k].runs.front().diagnostics.training_epochs.value_or(0));
  };
  made.search_epochs += epochs(0);
  made.swarm_epochs = epochs(1);
  made.gains = gains_of(twin, options, progress);
  add_figures(made, record, options, progress);
  return made;
}

}  // namespace proofmass
