// SPDX-License-Identifier: Apache-2.0
// Compares the errors of every method with the floor on a simulated twin, over seeds: one Markdown table per
// noise level.
//   accuracy TWIN.toml [seeds] [ols,bp-lm,...]
// Seed s determines both the record and the method's own random numbers. The floor is the test RMSE of
// full-model least squares on the same split; "x sigma" divides by the simulated noise.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/method.hpp"
#include "proofmass/identify/network/presets.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "proofmass/stand/twin/simulation_file.hpp"

namespace {

using namespace proofmass;

struct Contestant {
  std::string name;
  Method method;
};

std::vector<Contestant> contestants() {
  std::vector<Contestant> list;
  list.push_back({"ols", Ols{}});

  list.push_back({"bp-lm", Bp{.network = {.training = {.trainer = Trainer::lm}}}});
  list.push_back(
      {"bp-lm-early", Bp{.network = {.training = {.trainer = Trainer::lm}, .early_stopping = true}}});
  list.push_back({"bp", Bp{}});
  list.push_back({"bp-early", Bp{.network = {.training = {}, .early_stopping = true}}});

  PsoBp paper;
  apply_paper_preset(paper);
  list.push_back({"pso-bp-paper", paper});
  Bp multistart;  // the same 50,000 epochs and the same final training, without a swarm
  apply_paper_preset(multistart);
  multistart.starts = 50 * 51;
  multistart.start_epochs = paper.fitness_epochs;
  list.push_back({"multistart-paper", multistart});

  const PsoBp swarm;
  list.push_back({"pso-bp", swarm});
  // As many random starts as the swarm has particles, refined alike.
  list.push_back({"multistart",
                  Bp{.network = {}, .starts = swarm.particles, .start_epochs = 1, .refined = swarm.refined}});
  return list;
}

struct Tally {
  std::vector<double> over_floor, over_sigma, seconds, epochs;
  double worst_error = 0.0;   // largest |coefficient error| / standard error
  double square_error = 0.0;  // sum of (error / standard error)²
  double errors = 0.0;        // their number

  void add(const Identification& result, const StaticModel& truth, double floor, double sigma, double time) {
    over_floor.push_back(result.test->rmse / floor);
    over_sigma.push_back(result.test->rmse / sigma);
    seconds.push_back(time);
    const auto* const network = std::get_if<NetworkDetails>(&result.details);
    epochs.push_back(network != nullptr ? static_cast<double>(network->training_epochs) : 0.0);
    for (const Coefficient& c : result.coefficients) {
      if (!c.identified || !c.standard_error) continue;
      const double z = std::abs(c.value - truth.coefficient(c.term)) / *c.standard_error;
      worst_error = std::max(worst_error, z);
      square_error += z * z;
      errors += 1.0;
    }
  }
};

double geometric_mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += std::log(value);
  return std::exp(sum / static_cast<double>(values.size()));
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void print_row(const std::string& name, const Tally& t) {
  const auto [best, worst] = std::minmax_element(t.over_floor.begin(), t.over_floor.end());
  fmt::print("| {} | {:.4g} | {:.4g} | {:.4g} | {:.4g} | {:.4g} | {:.3g} | {:.3g} | {:.0f} | {:.2f} |\n",
             name, geometric_mean(t.over_sigma), geometric_mean(t.over_floor), median(t.over_floor), *best,
             *worst, t.errors > 0 ? std::sqrt(t.square_error / t.errors) : 0.0, t.worst_error,
             median(t.epochs), median(t.seconds));
  std::fflush(stdout);
}

Tally measure(const SimulationPlan& plan, const Contestant& contestant, std::size_t seeds) {
  const StaticModel truth = plan.truth();
  Tally tally;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Dataset record = simulate(plan, plan.rows, seed);
    const IdentifyOptions options{.terms = full_terms(), .seed = seed, .split = kTrainingFraction};
    const double floor = identify(record, Ols{}, options).identification.test->rmse;
    const auto start = std::chrono::steady_clock::now();
    const Run run = identify(record, contestant.method, options);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    tally.add(run.identification, truth, floor, plan.noise.sigma, time.count());
  }
  return tally;
}

// The gain of the paper's swarm, and of its multistart with as many epochs, over textbook BP.
void print_ratios(const std::map<std::string, Tally>& tallies) {
  const auto bp = tallies.find("bp-lm");
  for (const char* const name : {"pso-bp-paper", "multistart-paper", "pso-bp"}) {
    const auto other = tallies.find(name);
    if (bp == tallies.end() || other == tallies.end()) continue;
    const double ratio = geometric_mean(bp->second.over_sigma) / geometric_mean(other->second.over_sigma);
    fmt::print("\nTest MSE of bp-lm over that of {}, geometric means: {:.3g}\n", name, ratio * ratio);
  }
}

void tabulate(const SimulationPlan& plan, std::size_t seeds, const std::string& wanted) {
  fmt::print(
      "| method | gmean x sigma | gmean x floor | median | best | worst | rms error/se | max error/se | "
      "epochs | s |\n"
      "|---|---|---|---|---|---|---|---|---|---|\n");
  std::map<std::string, Tally> tallies;
  for (const Contestant& contestant : contestants()) {
    if (!wanted.empty() && ("," + wanted + ",").find("," + contestant.name + ",") == std::string::npos)
      continue;
    const Tally& tally = tallies[contestant.name] = measure(plan, contestant, seeds);
    print_row(contestant.name, tally);
  }
  print_ratios(tallies);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: accuracy TWIN.toml [seeds] [methods]\n");
    return 2;
  }
  try {
    const proofmass::SimulationPlan plan = proofmass::read_simulation(argv[1]);
    const std::size_t seeds = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 10;
    if (seeds == 0) throw proofmass::usage_error("the number of seeds must be a whole number above zero");
    fmt::print("\n{}: sigma {:.4g} g, {} rows, {} seeds\n\n", argv[1], plan.noise.sigma, plan.rows, seeds);
    tabulate(plan, seeds, argc > 3 ? argv[3] : "");
  } catch (const proofmass::Error& error) {
    fmt::print(stderr, "accuracy: {}\n", error.what());
    return proofmass::exit_code(error.kind());
  }
  return 0;
}
