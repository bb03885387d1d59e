// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/core/identification.hpp"

namespace proofmass {

enum class Part : std::uint8_t { training, validation, test };

// Row numbers of the parts of a record, ascending.
struct Split {
  std::vector<std::size_t> training;
  std::vector<std::size_t> validation;
  std::vector<std::size_t> test;
};

// The part of each of so many rows.
[[nodiscard]] std::vector<Part> parts_of(const Split& split, std::size_t rows);

// Where a result came from, enough to make it again.
struct Provenance {
  std::string version;
  std::string input;  // file name
  std::string input_sha256;
  std::string acceleration_unit{};  // of the record, as it declares it; empty: not known
  std::vector<std::pair<std::string, std::string>> options;  // resolved, in a fixed order
  std::vector<Finding> reading;  // what reading the record skipped, converted and assumed
};

// A record's way through the pipeline: which rows did what, what came of it, and by which settings.
struct Run {
  Split split;  // empty parts when the run was read from a result file, which does not keep them
  Identification identification;
  Provenance provenance;
  double seconds = 0.0;  // that splitting, fitting and scoring took; zero when read from a result file
};

}  // namespace proofmass
