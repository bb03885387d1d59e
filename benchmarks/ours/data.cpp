// SPDX-License-Identifier: Apache-2.0
// Writes the data of all contestants:
//   bench_data TWIN.toml FOLDER [ROWS]...
// samples.csv and test.csv: x1, x2, x3, target of the training and test rows, scaled to [-1, 1] by the
// training rows; starts.csv: ten networks to train; swarm.csv: fifty to evaluate; starts-H.csv: one with H
// hidden units; scale.json: the output that a scaled value of 1 stands for, over the noise; columns-ROWS.f64:
// Ai, Ao, Ap, E of a longer record.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/identify/network/training/starts.hpp"
#include "proofmass/split.hpp"
#include "proofmass/stand/twin/simulation_file.hpp"

namespace {

using namespace proofmass;
namespace fs = std::filesystem;

constexpr std::uint64_t kSeed = 1;  // of the split and of the starts

void write_samples(const fs::path& path, const Samples& samples) {
  std::ofstream file(path);
  for (std::size_t row = 0; row < samples.rows(); ++row) {
    for (std::size_t k = 0; k < samples.inputs(); ++k) file << fmt::format("{},", samples.input_data(k)[row]);
    file << fmt::format("{}\n", samples.target()[row]);
  }
}

// All weights of a network, by Nguyen and Widrow, with a random output layer.
void write_starts(const fs::path& path, std::size_t hidden, std::size_t first, std::size_t count) {
  std::ofstream file(path);
  const PerceptronShape shape{.inputs = 3, .hidden = hidden};
  for (std::size_t index = first; index < first + count; ++index) {
    file << fmt::format("{}\n", fmt::join(random_start(shape, Trainer::lm, kSeed, index), ","));
  }
}

void write_networks_data(const SimulationPlan& plan, const fs::path& folder) {
  const Dataset record = simulate(plan);
  const Split split = split_rows(record.rows(), {}, kSeed);
  const Dataset training = record.select(split.training);
  const TrainedNetwork network = learn_scaling(training);
  write_samples(folder / "samples.csv", scale_rows(network, training));
  write_samples(folder / "test.csv", scale_rows(network, record.select(split.test)));
  std::ofstream(folder / "scale.json") << fmt::format(
      "{{\"unit_over_sigma\": {}}}\n", output_half_range(network) / (plan.noise.sigma * plan.output_per_g));
  write_starts(folder / "starts.csv", 7, 0, 10);
  write_starts(folder / "swarm.csv", 7, 100, 50);
  for (const std::size_t hidden : {3U, 5U, 7U, 9U, 12U, 16U, 20U, 25U}) {
    write_starts(folder / fmt::format("starts-{}.csv", hidden), hidden, 0, 1);
  }
}

void write_columns(const SimulationPlan& plan, std::size_t rows, const fs::path& path) {
  if (fs::exists(path)) return;
  const Dataset record = simulate(plan, rows, plan.seed);
  std::ofstream file(path, std::ios::binary);
  const auto write = [&](const std::vector<double>& column) {
    file.write(reinterpret_cast<const char*>(column.data()),
               static_cast<std::streamsize>(column.size() * sizeof(double)));
  };
  for (const Axis axis : kAxes) write(record.along(axis));
  write(record.output);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: bench_data TWIN.toml FOLDER [ROWS]...\n");
    return 2;
  }
  try {
    const SimulationPlan plan = read_simulation(argv[1]);
    const fs::path folder = argv[2];
    fs::create_directories(folder);
    write_networks_data(plan, folder);
    for (int k = 3; k < argc; ++k) {
      write_columns(plan, std::strtoul(argv[k], nullptr, 10),
                    folder / fmt::format("columns-{}.f64", argv[k]));
    }
  } catch (const Error& error) {
    fmt::print(stderr, "bench_data: {}\n", error.what());
    return exit_code(error.kind());
  }
  return 0;
}
