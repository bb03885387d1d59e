// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "proofmass/core/run.hpp"

namespace proofmass {

// How a record is divided.
struct SplitOptions {
  double training_share = 0.7;     // of all rows; 1 fits all rows and leaves the test part empty
  double validation_share = 0.15;  // of all rows, taken from the training rows
  bool early_stopping = false;     // whether network methods get a validation part
};

// round(training_share * rows) rows drawn at random for training, of which round(validation_share * rows) are
// set aside for validation when early stopping is on; the rest are for testing. The test part depends on
// rows, training share and seed alone, so every method sees the same. Throws a usage Error on shares that
// leave no training rows.
[[nodiscard]] Split split_rows(std::size_t rows, const SplitOptions& options, std::uint64_t seed);

// Divisions of the training rows of a record, `rows` of them, for trials: number r, by seed + r, sets the
// validation share aside and trains on the rest. Throws a usage Error when no row is set aside.
[[nodiscard]] std::vector<Split> split_for_trials(std::size_t rows, const SplitOptions& options,
                                                  std::uint64_t seed, std::size_t trials);

}  // namespace proofmass
