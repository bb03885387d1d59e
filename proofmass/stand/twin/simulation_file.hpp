// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "proofmass/stand/twin/simulation.hpp"

namespace proofmass {

// Reads a simulation plan in the format of docs/simulation.md. Unknown keys and terms, wrong types, values
// out of range and an incomplete plan throw a bad-data Error with file, line and key.
[[nodiscard]] SimulationPlan read_simulation(const std::filesystem::path& path);

// The plan of data/twin-300ug.toml, compiled into the library: the paper's accelerometer with the paper's
// noise.
[[nodiscard]] SimulationPlan paper_twin();

}  // namespace proofmass
