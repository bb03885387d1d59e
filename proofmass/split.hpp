// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

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

}  // namespace proofmass
