// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <optional>
#include <ostream>
#include <string>

#include "common_flags.hpp"
#include "output.hpp"
#include "proofmass/record/csv/writer.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "proofmass/stand/twin/simulation_file.hpp"
#include "verbs/verbs.hpp"

namespace proofmass::cli {
namespace {

constexpr std::uint64_t kMostRows = 100'000'000;
constexpr double kMostSigmaUg = 1e9;
constexpr double kGPerUg = 1e-6;

struct SimulateFlags {
  CommonFlags common;
  std::string plan;
  std::string out = "-";
  std::optional<std::uint64_t> rows, seed;
  std::optional<double> sigma_ug;
};

void run_simulate(const SimulateFlags& flags) {
  require_other_file(flags.out, {flags.plan});
  require_writable_file(flags.out);
  SimulationPlan plan = read_simulation(flags.plan);
  if (flags.rows) plan.rows = *flags.rows;
  if (flags.seed) plan.seed = *flags.seed;
  if (flags.sigma_ug) plan.noise.sigma = *flags.sigma_ug * kGPerUg;

  const Dataset record = simulate(plan);
  OutputFiles files;
  files.add(flags.out, [&](std::ostream& out) {
    write_record(out, record,
                 {.units = RecordUnits::declared, .comments = describe(plan, plan.rows, plan.seed)});
  });
  stop_if_interrupted();
  files.commit();
}

}  // namespace

Action add_simulate(CLI::App& verb) {
  auto flags = std::make_shared<SimulateFlags>();
  verb.add_option("STAND.toml", flags->plan, "The plan: model, inputs, noise, rows and seed")->required();
  add_path(verb, "--out", flags->out, "The record to write; -, the default, is standard output")
      ->type_name("FILE");
  add_whole(verb, "--rows", 1, kMostRows, "Rows, in place of the plan's",
            [flags](std::uint64_t n) { flags->rows = n; });
  add_whole(verb, "--seed", 0, std::numeric_limits<std::uint64_t>::max(), "Seed, in place of the plan's",
            [flags](std::uint64_t n) { flags->seed = n; });
  add_real(verb, "--sigma-ug", {.low = 0.0, .high = kMostSigmaUg},
           "Standard deviation of the white output noise in µg, in place of the plan's",
           [flags](double sigma) { flags->sigma_ug = sigma; });
  add_language(verb, flags->common);
  add_common(verb, flags->common);
  verb.footer(
      "Examples:\n"
      "  proofmass simulate data/twin.toml --out run.csv\n"
      "  proofmass simulate data/twin.toml --rows 500 --seed 7 --sigma-ug 300 | head\n");
  return [flags] { run_simulate(*flags); };
}

}  // namespace proofmass::cli
