// SPDX-License-Identifier: Apache-2.0
// How often clean records get a warning or a note: a Markdown table of kinds of records, each with the method
// that is right for it, over sensors drawn at random.
//   false_alarms [records of each kind] [first seed]
// A kind's records have no fault: what is said of them, beside correlations and what figures rest on, is a
// false alarm. The codes and how often they were said go to standard error.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numbers>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "clean_records.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/numeric/parallel.hpp"
#include "proofmass/numeric/random.hpp"
#include "proofmass/pipeline.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "proofmass/stand/twin/simulation_file.hpp"

namespace {

using namespace proofmass;

// A kind of records: how they are made, and what is right for them.
struct Kind {
  std::string name;
  Method method;
  SimulationPlan plan;
  std::size_t rows = 0;
  double step = 0.0;             // of the output, in its canonical unit; 0: not rounded
  double inputs_step = 0.0;      // g
  bool with_conditions = false;  // columns t, T and sigma_E
  void (*also)(Dataset&, RandomStream&) = nullptr;
};

// Sizes as quartz flexure accelerometers have: mg, 1000 ppm, tens of µg/g², µg/g³, hundreds of µrad.
StaticModel draw_sensor(RandomStream& random) {
  StaticModel sensor{.terms = full_terms(), .coefficients = {}};
  for (const Term term : sensor.terms) {
    constexpr std::array<double, 4> kSizes{1e-3, 1e-4, 3e-5, 1e-6};
    const double size = term == Term::Ki ? 1e-3 : kSizes[static_cast<std::size_t>(info(term).order())];
    sensor.coefficients.push_back((term == Term::Ki ? 1.0 : 0.0) + size * random.normal());
  }
  return sensor;
}

// The input axis along the radius, inwards and outwards, without gravity.
SimulationPlan one_axis(double sigma) {
  SimulationPlan plan;
  plan.mounted = MountedInputs{
      .mounts = {{.name = "in", .radial = {1.0, 0.0, 0.0}}, {.name = "out", .radial = {-1.0, 0.0, 0.0}}},
      .levels = {1.0, 2.0, 5.0, 10.0, 20.0}};
  plan.noise.sigma = sigma;
  return plan;
}

SimulationPlan volts(SimulationPlan plan) {
  plan.output_unit = find_unit("V").value();
  plan.output_per_g = 1.25;
  return plan;
}

// 24 positions at 15 degrees in the plane of IA and OA, and 24 in that of IA and PA, in 1 g.
SimulationPlan tumble(double sigma) {
  SimulationPlan plan;
  MountedInputs inputs{.mounts = {}, .levels = {0.0}};
  for (int plane = 0; plane < 2; ++plane) {
    for (int k = 0; k < 24; ++k) {
      const double angle = k * std::numbers::pi / 12.0;
      const double across = std::sin(angle);
      inputs.mounts.push_back(
          {.name = fmt::format("{} {}", plane == 0 ? "OA" : "PA", 15 * k),
           .radial = {1.0, 0.0, 0.0},
           .up = {{std::cos(angle), plane == 0 ? across : 0.0, plane == 0 ? 0.0 : across}}});
    }
  }
  plan.mounted = inputs;
  plan.noise.sigma = sigma;
  return plan;
}

// Twelve positions in each plane, and no more rows than that.
SimulationPlan short_tumble(double sigma) {
  SimulationPlan plan = tumble(sigma);
  std::vector<Mount>& positions = plan.mounted->mounts;
  for (std::size_t k = 0; 2 * k < positions.size(); ++k) positions[k] = positions[2 * k];
  positions.resize(positions.size() / 2);
  return plan;
}

// The mount of a position is the plane that it is in.
void name_planes(Dataset& record, RandomStream& /*random*/) {
  for (std::string& mount : record.mount) mount.resize(2);
}

// Noise between 10 and 100 ug, different from mount to mount.
void add_noise_of_mounts(Dataset& record, RandomStream& random) {
  std::map<std::string, double> sigma;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    const auto [at, is_new] = sigma.try_emplace(record.mount[row], 0.0);
    if (is_new) at->second = 10.0 * kUg * std::pow(10.0, random.uniform());
    record.output[row] += at->second * random.normal();
  }
}

// The input axis alone.
void leave_one_axis(Dataset& record, RandomStream& /*random*/) {
  record.acceleration[1].clear();
  record.acceleration[2].clear();
}

// In the order of Ai as it was measured.
void sort_by_input(Dataset& record, RandomStream& /*random*/) {
  std::vector<std::size_t> order(record.rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::vector<double>& a = record.along(Axis::input);
  std::sort(order.begin(), order.end(), [&a](std::size_t x, std::size_t y) { return a[x] < a[y]; });
  record = record.select(order);
}

// Inputs measured with 100 ug.
SimulationPlan with_noisy_inputs(SimulationPlan plan) {
  plan.input_sigma = {100.0 * kUg, 100.0 * kUg, 100.0 * kUg};
  plan.record_sigma = true;
  return plan;
}

SimulationPlan mounts(double sigma) {
  SimulationPlan plan = read_simulation("data/mounts-24.toml");
  plan.noise.sigma = sigma;
  return plan;
}

std::vector<Kind> kinds() {
  SimulationPlan heavy = sphere(10.0 * kUg);
  heavy.noise.student_dof = 3.0;
  SimulationPlan outliers = sphere(10.0 * kUg);
  outliers.noise.outlier_fraction = 0.05;
  outliers.noise.outlier_magnitude = 1e-3;
  SimulationPlan growing = sphere(10.0 * kUg);
  growing.noise.sigma_per_g = 10.0 * kUg;
  return {
      {.name = "random directions, 1 to 20 g", .method = Ols{}, .plan = sphere(10.0 * kUg), .rows = 2000},
      {.name = "the same, 100 rows with t, T and sigma_E",
       .method = Ols{},
       .plan = sphere(300.0 * kUg),
       .rows = 100,
       .with_conditions = true},
      {.name = "heavy tails (Student, 3 degrees of freedom)",
       .method = Robust{},
       .plan = heavy,
       .rows = 1000},
      {.name = "5 % outliers", .method = Robust{}, .plan = outliers, .rows = 1000},
      {.name = "noise that grows with \\|A\\|", .method = Wls{}, .plan = growing, .rows = 1000},
      {.name = "noisy inputs, with sigma columns",
       .method = Eiv{},
       .plan = with_noisy_inputs(sphere(10.0 * kUg)),
       .rows = 500},
      {.name = "24 mounts, 16 levels to 70 g", .method = Ols{}, .plan = mounts(10.0 * kUg), .rows = 384},
      {.name = "the same three times, in V with 5 decimals",
       .method = Ols{},
       .plan = volts(mounts(30.0 * kUg)),
       .rows = 1152,
       .step = 1e-5,
       .with_conditions = true},
      {.name = "tumble, 48 positions, in V with 6 decimals",
       .method = Ols{},
       .plan = volts(tumble(10.0 * kUg)),
       .rows = 48,
       .step = 1e-6,
       .inputs_step = 1e-6},
      {.name = "the same four times",
       .method = Ols{},
       .plan = volts(tumble(10.0 * kUg)),
       .rows = 192,
       .step = 1e-6,
       .inputs_step = 1e-6,
       .with_conditions = true},
      {.name = "the same, steps of three times the noise",
       .method = Ols{},
       .plan = volts(tumble(10.0 * kUg)),
       .rows = 192,
       .step = 4e-5,
       .inputs_step = 1e-6,
       .with_conditions = true},
      {.name = "tumble, 24 positions, two mounts",
       .method = Ols{},
       .plan = short_tumble(10.0 * kUg),
       .rows = 24,
       .inputs_step = 1e-6,
       .also = name_planes},
      {.name = "random directions, 30 rows", .method = Ols{}, .plan = sphere(10.0 * kUg), .rows = 30},
      {.name = "noise of 1 to 100 ug by row, with sigma_E",
       .method = Ols{},
       .plan = sphere(0.1 * kUg),
       .rows = 100,
       .also = add_uneven_noise},
      {.name = "noise of 10 to 100 ug by mount, 24 mounts",
       .method = Ols{},
       .plan = mounts(kUg),
       .rows = 384,
       .also = add_noise_of_mounts},
      {.name = "noisy inputs, in the order of Ai",
       .method = Eiv{},
       .plan = with_noisy_inputs(sphere(10.0 * kUg)),
       .rows = 100,
       .also = sort_by_input},
      {.name = "tumble, 48 positions, noisy inputs",
       .method = Eiv{},
       .plan = with_noisy_inputs(tumble(10.0 * kUg)),
       .rows = 48},
      {.name = "one axis, 10 levels, five times",
       .method = Ols{},
       .plan = one_axis(10.0 * kUg),
       .rows = 50,
       .also = leave_one_axis},
  };
}

void round_to(std::vector<double>& values, double step) {
  if (step == 0.0) return;
  const double per_unit = std::nearbyint(1.0 / step);
  for (double& value : values) value = std::nearbyint(value * per_unit) / per_unit;
}

// A clock that starts at noon, and a room whose temperature wanders.
void add_conditions(Dataset& record, const Kind& kind, RandomStream& random) {
  double temperature = 23.0;
  const double sigma =
      std::hypot(kind.plan.noise.sigma * kind.plan.output_per_g, kind.step / std::sqrt(12.0));
  for (std::size_t row = 0; row < record.rows(); ++row) {
    temperature += 0.02 * random.normal();
    record.time.push_back(43'200.0 + 12.0 * static_cast<double>(row));
    record.temperature.push_back(temperature);
    record.output_sigma.push_back(sigma);
  }
}

Dataset make_record(const Kind& kind, std::uint64_t seed) {
  RandomStream random(seed, stream_id("sensor"));
  SimulationPlan plan = kind.plan;
  plan.model = draw_sensor(random);
  Dataset record = simulate(plan, kind.rows, seed);
  round_to(record.output, kind.step);
  for (std::vector<double>& axis : record.acceleration) round_to(axis, kind.inputs_step);
  record.acceleration_resolution.fill(kind.inputs_step);
  if (kind.also != nullptr) kind.also(record, random);
  if (kind.with_conditions) add_conditions(record, kind, random);
  return record;
}

struct Count {
  std::size_t warned = 0;
  std::size_t noted = 0;
  std::map<std::string, std::size_t> codes;
};

void count(const Identification& result, Count& counts) {
  bool warned = false;
  bool noted = false;
  for (const Finding& finding : result.findings) {
    if (finding.severity == Severity::basis || finding.code == Code::inputs_collinear) continue;
    warned = warned || finding.severity == Severity::warning;
    noted = noted || finding.severity == Severity::note;
    ++counts.codes[fmt::format("{} {}", to_string(finding.severity), to_string(finding.code))];
  }
  counts.warned += warned ? 1U : 0U;
  counts.noted += noted ? 1U : 0U;
}

Count measure(const Kind& kind, std::size_t records, std::uint64_t first_seed) {
  Count counts;
  TermList terms;
  for (std::uint64_t seed = first_seed; seed < first_seed + records; ++seed) {
    const Dataset record = make_record(kind, seed);
    if (terms.empty()) terms = analyse_identifiability(record, full_terms()).identified;
    count(identify(record, kind.method, {.terms = terms, .seed = seed}).identification, counts);
  }
  return counts;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t records = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000;
  const std::uint64_t first_seed = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1;
  try {
    fmt::print("| records ({} of each kind) | method | with a warning | with a note |\n|---|---|---|---|\n",
               records);
    for (const Kind& kind : kinds()) {
      const Count counts = measure(kind, records, first_seed);
      const auto percent = [records](std::size_t n) {
        return 100.0 * static_cast<double>(n) / static_cast<double>(records);
      };
      fmt::print("| {} | {} | {:.1f} % | {:.1f} % |\n", kind.name, info(kind.method).name,
                 percent(counts.warned), percent(counts.noted));
      std::fflush(stdout);
      for (const auto& [code, times] : counts.codes)
        fmt::print(stderr, "{}: {} {}\n", kind.name, times, code);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "false_alarms: {}\n", error.what());
    return 1;
  }
}
