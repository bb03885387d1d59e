// SPDX-License-Identifier: Apache-2.0
// What a record holds and what its inputs could identify, before any fit.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/identify/model/identifiability.hpp"

namespace proofmass {

struct ColumnSummary {
  std::string name;  // as the contract calls it: "Ai", "sigma_E"
  std::string unit;  // as the record declares it; the figures are in it
  double minimum = 0.0;
  double maximum = 0.0;
  double mean = 0.0;
};

struct MountSummary {
  std::string name;
  std::size_t rows = 0;
};

// Whether a preset's terms can be told apart, and which cannot.
struct PresetVerdict {
  std::string name;
  std::size_t terms = 0;
  std::size_t rows_needed = 0;  // terms + 1; fewer rows are not fitted
  Identifiability found;
};

struct Inspection {
  std::string source;
  std::string source_sha256;
  std::size_t rows = 0;
  std::vector<ColumnSummary> columns;
  std::vector<Axis> axes;
  std::vector<MountSummary> mounts;  // in the order of their first rows
  bool has_output_sigma = false;
  std::vector<Axis> axes_with_sigma;
  std::vector<IgnoredColumn> ignored;  // columns of the file that no step uses
  std::vector<Finding> findings;       // what reading skipped, converted and assumed, and what cannot be
  std::size_t repeated_inputs = 0;     // rows whose accelerations equal an earlier row's
  std::size_t repeated_rows = 0;       // and whose output does too
  std::vector<PresetVerdict> presets;  // linear, quadratic, paper, full: the last judges each of the 21 terms
};

// Throws a bad-data Error when the record has no rows.
[[nodiscard]] Inspection inspect(const Dataset& record);

}  // namespace proofmass
