// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/method.hpp"

namespace proofmass {

// How a record is divided.
struct SplitOptions {
  double training_share = 0.7;     // of all rows; 1 fits all rows and leaves the test part empty
  double validation_share = 0.15;  // of all rows, taken from the training rows
  bool early_stopping = false;     // whether network methods get a validation part
};

// Row numbers of the parts of a record, ascending.
struct Split {
  std::vector<std::size_t> training;
  std::vector<std::size_t> validation;
  std::vector<std::size_t> test;
};

// round(training_share * rows) rows drawn at random for training, of which round(validation_share * rows) are
// set aside for validation when early stopping is on; the rest are for testing. The test part depends on
// rows, training share and seed alone, so every method sees the same. Throws a usage Error on shares that
// leave no training rows.
[[nodiscard]] Split split_rows(std::size_t rows, const SplitOptions& options, std::uint64_t seed);

// The split that a method gets: only networks stop early, others train on the validation rows too.
[[nodiscard]] SplitOptions split_for(const Method& method, SplitOptions options) noexcept;

// The paper's PSO-BP: apply_paper_preset of identify/presets.hpp, and early stopping.
void apply_paper_preset(IdentifyOptions& options, SplitOptions& split);

// Splits the record by split_for, identifies on the training rows, and assesses on every part.
[[nodiscard]] Identification run(const Dataset& record, const Method& method, const IdentifyOptions& options,
                                 const SplitOptions& split_options, Progress& progress);

}  // namespace proofmass
