// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "proofmass/core/run.hpp"
#include "proofmass/identify/options/method_info.hpp"

namespace proofmass {

// How a record is divided.
struct SplitOptions {
  double training_fraction =
      kTrainingFraction;             // of all rows; 1 fits all rows and leaves the test part empty
  double validation_fraction = 0.0;  // of all rows, taken from the training rows
};

// round(training_fraction * rows) rows drawn at random for training, of which
// round(validation_fraction * rows) are set aside for validation; the rest are for testing. The test part
// depends on rows, training fraction and seed alone, so every method sees the same. Throws a usage Error on
// fractions that leave no training rows, of which some validation is left no row, or less than 1 that leave
// no row of several for testing; that of the last has the fractions that would do.
[[nodiscard]] Split split_rows(std::size_t rows, const SplitOptions& options, std::uint64_t seed);

// The same with whole mounts, `mounts` being the label of each row: as many mounts, drawn at random, as come
// nearest to the fractions, at least one for each part that is asked for. The test part depends on mounts,
// training fraction and seed alone. Throws a usage Error also where there are fewer mounts than parts.
[[nodiscard]] Split split_mounts(std::span<const std::string> mounts, const SplitOptions& options,
                                 std::uint64_t seed);

// Divisions of the training rows of a record, `rows` of them, for trials: number r, by seed + r, sets the
// validation fraction aside and trains on the rest. Throws a usage Error when no row is set aside.
[[nodiscard]] std::vector<Split> split_for_trials(std::size_t rows, const SplitOptions& options,
                                                  std::uint64_t seed, std::size_t trials);
[[nodiscard]] std::vector<Split> split_mounts_for_trials(std::span<const std::string> mounts,
                                                         const SplitOptions& options, std::uint64_t seed,
                                                         std::size_t trials);

}  // namespace proofmass
