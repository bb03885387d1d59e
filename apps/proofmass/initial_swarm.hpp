// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace proofmass::cli {

// Reads positions of a swarm: a line a particle, numbers between commas; blank lines and lines that begin
// with # are skipped. Throws a bad-data Error with file, line and text on what is not a finite number, and on
// no position at all.
[[nodiscard]] std::vector<std::vector<double>> read_positions(const std::filesystem::path& path);

}  // namespace proofmass::cli
