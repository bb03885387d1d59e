// SPDX-License-Identifier: Apache-2.0
// Compares all methods on a simulated twin, over seeds, with the best possible result: a Markdown table.
//   methods TWIN.toml MODEL [seeds]
// Seed s determines the record, the split and the method's own random numbers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/network/presets.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "proofmass/stand/twin/simulation_file.hpp"
#include "proofmass/study/compare.hpp"
#include "proofmass/study/truth.hpp"

namespace {

using namespace proofmass;

constexpr double kSmallInputSigma = 1e-6;  // g

bool exact_inputs(const SimulationPlan& plan) { return plan.input_sigma == std::array<double, 3>{}; }

// tls and eiv get the simulated uncertainties, unless the record has them. They refuse exact inputs: then
// they get an input uncertainty of 1 µg.
std::vector<Entry> entries(const SimulationPlan& plan, const TermList& terms) {
  UncertaintyOptions uncertainty;
  if (!plan.record_sigma) {
    uncertainty.output = plan.noise.sigma;
    uncertainty.input = *std::max_element(plan.input_sigma.begin(), plan.input_sigma.end());
  }
  if (exact_inputs(plan)) uncertainty.input = kSmallInputSigma;
  const std::string inputs = exact_inputs(plan) ? ", inputs ± 1 µg" : "";
  PsoBp paper;
  apply_paper_preset(paper);

  std::vector<Entry> list;
  const auto add = [&](std::string name, Method method) {
    list.push_back({.name = std::move(name), .method = std::move(method), .options = {.terms = terms}});
  };
  add("ols", Ols{});
  add("wls, variance model", Wls{.weights = WeightSource::model});
  add("robust, Huber", Robust{.loss = LossKind::huber, .tuning = {}});
  add("robust, bisquare", Robust{});
  add("tls" + inputs, Tls{.uncertainty = uncertainty});
  add("eiv" + inputs, Eiv{.uncertainty = uncertainty});
  add("gmdh, combi", Gmdh{});
  add("gmdh, mia", Gmdh{.form = GmdhForm::mia});
  add("afsa", Afsa{});
  add("afsa, columns", Afsa{.target = {}, .coordinates = FishCoordinates::columns});
  add("bp, textbook", Bp{.network = {.training = {.trainer = Trainer::lm}}});
  add("bp", Bp{});
  add("pso-bp, paper", paper);
  add("pso-bp", PsoBp{});
  add("hybrid", Hybrid{});
  return list;
}

// Root mean square over the test rows of the part that no method can predict: measured output minus the true
// output at the true inputs or, where those are not recorded, at the recorded ones.
double noise_of(const SimulationPlan& plan, const Dataset& record, const std::vector<std::size_t>& test,
                std::uint64_t seed) {
  SimulationPlan quiet = plan;
  quiet.noise = {};
  quiet.record_sigma = false;
  quiet.input_sigma = {};
  const Dataset clean = simulate(quiet, plan.rows, seed);
  const StaticModel truth = plan.truth();
  double sum = 0.0;
  for (const std::size_t row : test) {
    const double best = exact_inputs(plan) ? clean.output[row] : truth.output(record.at(row));
    sum += (record.output[row] - best) * (record.output[row] - best);
  }
  return std::sqrt(sum / static_cast<double>(test.size())) / record.output_unit.to_canonical;
}

// The floor of the test error: that of least squares with all terms or, where the terms cannot represent the
// truth, the noise.
double floor_of(const SimulationPlan& plan, const Dataset& record, const std::vector<std::size_t>& test,
                std::uint64_t seed, const TermList& terms) {
  if (plan.unmodelled.saturating != 0.0 || plan.unmodelled.fourth_order != 0.0) {
    return noise_of(plan, record, test, seed);
  }
  return identify(record, Ols{}, {.terms = terms, .seed = seed, .split = kTrainingFraction})
      .identification.test->rmse;
}

struct Tally {
  double square_over_bound = 0.0;
  std::vector<double> over_floor, over_noise, seconds;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double geometric_mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += std::log(value);
  return std::exp(sum / static_cast<double>(values.size()));
}

std::string cells(const SimulationPlan& plan, Entry entry, std::size_t seeds) {
  SilentProgress progress;
  Tally tally;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Dataset record = simulate(plan, plan.rows, seed);
    entry.options.seed = seed;
    Comparison one = compare(record, std::span(&entry, 1), 1, progress);
    score_truth(one, record, plan);
    const Contestant& contestant = one.contestants.front();
    const double over_bound = contestant.truth->rms_over_bound.value();
    tally.square_over_bound += over_bound * over_bound;
    const Run& run = contestant.runs.front();
    const std::vector<std::size_t>& test = run.split.test;
    const double rmse = run.identification.test->rmse;
    tally.over_floor.push_back(rmse / floor_of(plan, record, test, seed, entry.options.terms));
    tally.over_noise.push_back(rmse / noise_of(plan, record, test, seed));
    tally.seconds.push_back(contestant.seconds.front());
  }
  const double rms = std::sqrt(tally.square_over_bound / static_cast<double>(seeds));
  return fmt::format("{:.4g} | {:.4g} | {:.4g} | {:.4g} | {:.3g}", rms, geometric_mean(tally.over_floor),
                     *std::max_element(tally.over_floor.begin(), tally.over_floor.end()),
                     geometric_mean(tally.over_noise), 1e3 * median(tally.seconds));
}

void tabulate(const SimulationPlan& plan, const std::string& model, std::size_t seeds) {
  fmt::print(
      "| method | error / bound | test RMSE / floor | worst | test RMSE / noise | ms |\n"
      "|---|---|---|---|---|---|\n");
  std::vector<std::string> refusals;
  for (const Entry& entry : entries(plan, parse_terms(model))) {
    std::string text;
    try {
      text = cells(plan, entry, seeds);
    } catch (const Error& error) {
      refusals.emplace_back(error.what());
      text = fmt::format("refused ({}) | | | |", refusals.size());
    }
    fmt::print("| {} | {} |\n", entry.name, text);
    std::fflush(stdout);
  }
  if (!refusals.empty()) fmt::print("\n");
  for (std::size_t k = 0; k < refusals.size(); ++k) fmt::print("({}) {}\n\n", k + 1, refusals[k]);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: methods TWIN.toml MODEL [seeds]\n");
    return 2;
  }
  try {
    const SimulationPlan plan = read_simulation(argv[1]);
    const std::size_t seeds = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 20;
    if (seeds == 0) throw usage_error("the number of seeds must be a whole number above zero");
    fmt::print("\n**{}**, model `{}`, {} seeds\n\n", argv[1], argv[2], seeds);
    tabulate(plan, argv[2], seeds);
  } catch (const Error& error) {
    fmt::print(stderr, "methods: {}\n", error.what());
    return exit_code(error.kind());
  }
  return 0;
}
