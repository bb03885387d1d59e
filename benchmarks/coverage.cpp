// SPDX-License-Identifier: Apache-2.0
// How often 95 % intervals hold the truth: a Markdown table of kinds of records, each with a method and a
// covariance that claim to be right for it, over sensors drawn at random, one a record.
//   coverage [records of each kind] [first seed] [networks]
// With `networks`, of networks, whose records take a second each; their intervals are also compared in width
// with those of least squares on the same rows.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "clean_records.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "proofmass/numeric/random.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "proofmass/stand/twin/simulation_file.hpp"

namespace {

using namespace proofmass;

struct Kind {
  std::string name;
  Method method;
  SimulationPlan plan;
  std::size_t rows = 0;
  CovarianceKind covariance = CovarianceKind::model;
  void (*also)(Dataset&, RandomStream&) = nullptr;
};

// The paper's coefficients with random signs and factors of 0.3 to 3, the six that it lacks 5e-8 to 5e-7.
StaticModel draw_sensor(const StaticModel& paper, RandomStream& random) {
  StaticModel sensor{.terms = full_terms(), .coefficients = {}};
  const auto between = [&](double low, double high) { return low * std::pow(high / low, random.uniform()); };
  for (const Term term : sensor.terms) {
    const double offset = term == Term::Ki ? 1.0 : 0.0;
    const double known = std::abs(paper.coefficient(term) - offset);
    const double size = known > 0.0 ? known * between(0.3, 3.0) : between(5e-8, 5e-7);
    sensor.coefficients.push_back(offset + (random.uniform() < 0.5 ? -size : size));
  }
  return sensor;
}

SimulationPlan growing() {
  SimulationPlan plan = sphere(10.0 * kUg);
  plan.noise.sigma_per_g = 10.0 * kUg;
  return plan;
}

SimulationPlan heavy_tails() {
  SimulationPlan plan = sphere(10.0 * kUg);
  plan.noise.student_dof = 3.0;
  return plan;
}

SimulationPlan outliers() {
  SimulationPlan plan = sphere(10.0 * kUg);
  plan.noise.outlier_fraction = 0.05;
  plan.noise.outlier_magnitude = 1e-3;
  return plan;
}

SimulationPlan noisy_inputs() {
  SimulationPlan plan = sphere(10.0 * kUg);
  plan.input_sigma = {0.1, 0.1, 0.1};
  plan.record_sigma = true;
  return plan;
}

SimulationPlan unmodelled() {
  SimulationPlan plan = sphere(10.0 * kUg);
  plan.unmodelled = {.saturating = 2e-4, .saturation_range = 3.0};
  return plan;
}

SimulationPlan mounts(const char* file) {
  SimulationPlan plan = read_simulation(file);
  plan.noise.sigma = 10.0 * kUg;
  return plan;
}

// An offset of each mount, ten times the noise.
void add_offsets_of_mounts(Dataset& record, RandomStream& random) {
  std::map<std::string, double> offsets;
  for (const std::string& mount : record.mount) offsets.try_emplace(mount, 0.0);
  for (auto& [mount, offset] : offsets) offset = 100.0 * kUg * random.normal();
  for (std::size_t row = 0; row < record.rows(); ++row) record.output[row] += offsets.at(record.mount[row]);
}

std::vector<Kind> kinds() {
  return {
      {.name = "white noise", .method = Ols{}, .plan = sphere(10.0 * kUg), .rows = 500},
      {.name = "white noise",
       .method = Ols{},
       .plan = sphere(10.0 * kUg),
       .rows = 500,
       .covariance = CovarianceKind::hc3},
      {.name = "known noise of each row",
       .method = Wls{},
       .plan = sphere(0.1 * kUg),
       .rows = 500,
       .also = add_uneven_noise},
      {.name = "noise that grows with \\|A\\|", .method = Ols{}, .plan = growing(), .rows = 500},
      {.name = "noise that grows with \\|A\\|",
       .method = Ols{},
       .plan = growing(),
       .rows = 500,
       .covariance = CovarianceKind::hc3},
      {.name = "noise that grows with \\|A\\|",
       .method = Wls{.weights = WeightSource::model},
       .plan = growing(),
       .rows = 500},
      {.name = "heavy tails (Student, 3 degrees of freedom)",
       .method = Robust{.loss = LossKind::huber},
       .plan = heavy_tails(),
       .rows = 500},
      {.name = "heavy tails (Student, 3 degrees of freedom)",
       .method = Robust{},
       .plan = heavy_tails(),
       .rows = 500},
      {.name = "5 % outliers", .method = Robust{.loss = LossKind::huber}, .plan = outliers(), .rows = 500},
      {.name = "5 % outliers", .method = Robust{}, .plan = outliers(), .rows = 500},
      {.name = "noise that grows with \\|A\\|",
       .method = Robust{.loss = LossKind::huber},
       .plan = growing(),
       .rows = 500,
       .covariance = CovarianceKind::hc3},
      {.name = "input noise of 0.1 g", .method = Eiv{}, .plan = noisy_inputs(), .rows = 500},
      {.name = "input noise of 0.1 g",
       .method = Eiv{},
       .plan = noisy_inputs(),
       .rows = 500,
       .covariance = CovarianceKind::hc3},
      {.name = "offsets of 24 mounts",
       .method = Ols{},
       .plan = mounts("data/mounts-24.toml"),
       .rows = 384,
       .also = add_offsets_of_mounts},
      {.name = "offsets of 24 mounts",
       .method = Ols{},
       .plan = mounts("data/mounts-24.toml"),
       .rows = 384,
       .covariance = CovarianceKind::mount,
       .also = add_offsets_of_mounts},
      {.name = "structure that the terms lack", .method = Hybrid{}, .plan = unmodelled(), .rows = 500},
  };
}

// Of networks, at three sizes of noise and up to 5 to 50 g.
std::vector<Kind> network_kinds() {
  std::vector<Kind> kinds;
  for (const Method& method : {Method(PsoBp{}), Method(Bp{})}) {
    for (const double sigma : {1.0, 20.0, 300.0}) {
      kinds.push_back({.name = fmt::format("white noise of {:.0f} µg", sigma),
                       .method = method,
                       .plan = sphere(sigma * kUg),
                       .rows = 2000});
    }
  }
  return kinds;
}

struct Record {
  Dataset data;
  StaticModel truth;
};

Record make_record(const Kind& kind, const StaticModel& paper, std::uint64_t seed) {
  RandomStream random(seed, stream_id("sensor"));
  SimulationPlan plan = kind.plan;
  plan.model = draw_sensor(paper, random);
  if (info(kind.method).predicts_by_network) plan.sphere->maximum = random.uniform(5.0, 50.0);
  Record made{.data = simulate(plan, kind.rows, seed), .truth = plan.truth()};
  if (kind.also != nullptr) kind.also(made.data, random);
  return made;
}

// What was covered, a term, in one record: 1, 0, or none where the term was not identified.
struct Covered {
  std::vector<int> terms;  // -1: not identified
  double width = 0.0;      // mean over the terms of the intervals' widths over those of least squares
};

double relative_width(const Identification& result, const Identification& least_squares) {
  double sum = 0.0;
  double count = 0.0;
  for (const Coefficient& c : result.coefficients) {
    const Coefficient& other = least_squares.find(c.term);
    if (!c.ci95 || !other.ci95) continue;
    sum += (c.ci95->high - c.ci95->low) / (other.ci95->high - other.ci95->low);
    count += 1.0;
  }
  return sum / count;
}

Covered covered(const Kind& kind, const StaticModel& paper, const TermList& terms, std::uint64_t seed) {
  const Record made = make_record(kind, paper, seed);
  const Run run =
      identify(made.data, kind.method, {.terms = terms, .seed = seed, .covariance = kind.covariance});
  Covered found;
  for (const Term term : terms) {
    const Coefficient& c = run.identification.find(term);
    const double truth = made.truth.coefficient(term);
    const bool known = c.identified && c.ci95;
    found.terms.push_back(known ? static_cast<int>(c.ci95->low <= truth && truth <= c.ci95->high) : -1);
  }
  if (info(kind.method).predicts_by_network) {
    const Run ols = identify(made.data, Ols{}, {.terms = terms, .seed = seed, .split = kTrainingFraction});
    found.width = relative_width(run.identification, ols.identification);
  }
  return found;
}

// Percentages of intervals that hold the truth.
struct Coverage {
  double pool = 0.0, least = 100.0, most = 0.0;
  Term least_term = Term::K0, most_term = Term::K0;
  double width = 0.0;
};

Coverage measure(const Kind& kind, const StaticModel& paper, std::size_t records, std::uint64_t first_seed) {
  const TermList terms =
      analyse_identifiability(make_record(kind, paper, first_seed).data, full_terms()).identified;
  std::vector<Covered> found(records);
  parallel_for(records, [&](std::size_t k) { found[k] = covered(kind, paper, terms, first_seed + k); });
  Coverage coverage;
  double all = 0.0, held = 0.0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    double of_term = 0.0, held_of_term = 0.0;
    for (const Covered& one : found) {
      if (one.terms[t] < 0) continue;
      of_term += 1.0;
      held_of_term += one.terms[t];
    }
    all += of_term;
    held += held_of_term;
    const double percent = 100.0 * held_of_term / of_term;
    if (percent < coverage.least) coverage.least = percent, coverage.least_term = terms[t];
    if (percent > coverage.most) coverage.most = percent, coverage.most_term = terms[t];
  }
  coverage.pool = 100.0 * held / all;
  for (const Covered& one : found) coverage.width += one.width / static_cast<double>(records);
  return coverage;
}

std::string method_text(const Kind& kind) {
  std::string text(info(kind.method).name);
  if (const auto* robust = std::get_if<Robust>(&kind.method))
    text += robust->loss == LossKind::huber ? ", huber" : ", bisquare";
  if (const auto* wls = std::get_if<Wls>(&kind.method))
    text += wls->weights == WeightSource::model ? ", weights model" : ", weights sigma";
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t records = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 2000;
  const std::uint64_t first_seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  const bool networks = argc > 3 && std::string_view(argv[3]) == "networks";
  try {
    const StaticModel paper = read_simulation("data/twin.toml").truth();
    fmt::print(
        "| records ({} of each kind) | method | {} | all coefficients | least | most |\n"
        "|---|---|---|---|---|---|\n",
        records, networks ? "width over that of ols" : "covariance");
    for (const Kind& kind : networks ? network_kinds() : kinds()) {
      const Coverage c = measure(kind, paper, records, first_seed);
      fmt::print("| {} | {} | {} | {:.1f} % | {:.1f} % ({}) | {:.1f} % ({}) |\n", kind.name,
                 method_text(kind),
                 networks ? fmt::format("{:.2f}", c.width) : std::string(to_string(kind.covariance)), c.pool,
                 c.least, name(c.least_term), c.most, name(c.most_term));
      std::fflush(stdout);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "coverage: {}\n", error.what());
    return 1;
  }
}
