// SPDX-License-Identifier: Apache-2.0
// How far PSO-BP stays above the floor on sensors drawn at random: a Markdown table of the test error over
// that of least squares with all terms on the same split. Every run goes to standard error.
//   network_floor [sensors] [records of each] [first sensor] [hidden units, 0: the default]
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "clean_records.hpp"
#include "proofmass/numeric/random.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "proofmass/stand/twin/simulation_file.hpp"

namespace {

using namespace proofmass;

constexpr double kAbove = 1.06;
constexpr double kFarAbove = 1.15;

double log_uniform(double low, double high, RandomStream& random) {
  return low * std::pow(high / low, random.uniform());
}

// The paper's coefficients with random signs and factors, and the six terms that it lacks.
StaticModel draw_model(const StaticModel& paper, RandomStream& random) {
  StaticModel model{.terms = full_terms(), .coefficients = {}};
  for (const Term term : model.terms) {
    const double sign = random.uniform() < 0.5 ? -1.0 : 1.0;
    const double known = paper.coefficient(term) - (term == Term::Ki ? 1.0 : 0.0);
    const double size =
        known != 0.0 ? known * log_uniform(0.3, 3.0, random) : log_uniform(5e-8, 5e-7, random);
    model.coefficients.push_back((term == Term::Ki ? 1.0 : 0.0) + sign * size);
  }
  return model;
}

SimulationPlan draw_plan(const StaticModel& paper, std::uint64_t sensor) {
  RandomStream random(sensor, stream_id("sensor"));
  SimulationPlan plan;
  plan.model = draw_model(paper, random);
  plan.sphere = SphereInputs{.minimum = 1.0, .maximum = 5.0 + 45.0 * random.uniform()};
  plan.noise.sigma = log_uniform(kUg, 300.0 * kUg, random);
  return plan;
}

// Of one sensor's runs.
struct Runs {
  std::vector<double> ratios;   // ascending in the end
  std::vector<double> seconds;  // of all processors
  std::size_t most_units = 0;
};

void run(const SimulationPlan& plan, const PsoBp& method, std::uint64_t sensor, std::uint64_t seed,
         Runs& runs) {
  const Dataset record = simulate(plan, 2000, seed);
  const IdentifyOptions options{.terms = full_terms(), .seed = seed, .split = 0.7};
  const double floor = identify(record, Ols{}, options).identification.test->rmse;
  const std::clock_t start = std::clock();
  const Identification found = identify(record, method, options).identification;
  runs.seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  runs.ratios.push_back(found.test->rmse / floor);
  runs.most_units = std::max(runs.most_units, found.network->hidden);
  fmt::print(stderr, "sensor {} ({:.1f} g, {:.1f} ug) seed {}: {:.4f}, {} units, {:.2f} s\n", sensor,
             plan.sphere->maximum, plan.noise.sigma / kUg, seed, runs.ratios.back(), found.network->hidden,
             runs.seconds.back());
}

std::size_t count_above(const std::vector<double>& ratios, double limit) {
  return static_cast<std::size_t>(
      std::count_if(ratios.begin(), ratios.end(), [limit](double ratio) { return ratio > limit; }));
}

void print_row(const std::string& name, Runs runs) {
  std::sort(runs.ratios.begin(), runs.ratios.end());
  std::sort(runs.seconds.begin(), runs.seconds.end());
  fmt::print("| {} | {} | {:.3f} | {} | {} | {:.3f} | {} | {:.2f} | {:.2f} |\n", name, runs.ratios.size(),
             runs.ratios[runs.ratios.size() / 2], count_above(runs.ratios, kAbove),
             count_above(runs.ratios, kFarAbove), runs.ratios.back(), runs.most_units,
             runs.seconds[runs.seconds.size() / 2], runs.seconds.back());
  std::fflush(stdout);
}

void join(Runs& all, const Runs& some) {
  all.ratios.insert(all.ratios.end(), some.ratios.begin(), some.ratios.end());
  all.seconds.insert(all.seconds.end(), some.seconds.begin(), some.seconds.end());
  all.most_units = std::max(all.most_units, some.most_units);
}

void measure(std::uint64_t sensors, std::uint64_t records, std::uint64_t first, const PsoBp& method) {
  const StaticModel paper = read_simulation("data/twin.toml").model;
  fmt::print(
      "| sensor | runs | median | above {:.2f} | above {:.2f} | worst | units, most | s, median | s, most |\n"
      "|---|---|---|---|---|---|---|---|---|\n",
      kAbove, kFarAbove);
  Runs all;
  for (std::uint64_t sensor = first; sensor < first + sensors; ++sensor) {
    const SimulationPlan plan = draw_plan(paper, sensor);
    Runs runs;
    for (std::uint64_t k = 0; k < records; ++k) run(plan, method, sensor, 1000 * sensor + k, runs);
    join(all, runs);
    print_row(fmt::format("{}: {:.0f} g, {:.1f} µg", sensor, plan.sphere->maximum, plan.noise.sigma / kUg),
              std::move(runs));
  }
  print_row("all", std::move(all));
}

}  // namespace

int main(int argc, char** argv) {
  const std::span<char*> given(argv, static_cast<std::size_t>(argc));
  const auto number = [given](std::size_t at, std::uint64_t otherwise) {
    return at < given.size() ? std::strtoull(given[at], nullptr, 10) : otherwise;
  };
  try {
    PsoBp method;
    if (number(4, 0) > 0) method.network.hidden = method.grow_to = number(4, 0);
    measure(number(1, 10), number(2, 40), number(3, 1), method);
  } catch (const std::exception& error) {
    fmt::print(stderr, "network_floor: {}\n", error.what());
    return 1;
  }
}
