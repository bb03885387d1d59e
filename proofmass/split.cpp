// SPDX-License-Identifier: Apache-2.0
#include "proofmass/split.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

// Checks the fractions and returns how many rows train, and how many of those validate.
std::pair<std::size_t, std::size_t> part_sizes(std::size_t rows, const SplitOptions& options) {
  const double training = options.training_fraction;
  if (!(training > 0.0 && training <= 1.0)) {
    throw usage_error(fmt::format("split must be more than 0 and at most 1, got {}", training));
  }
  const double validation = options.validation_fraction;
  if (!(validation >= 0.0 && validation < training)) {
    throw usage_error(fmt::format(
        "the validation fraction must be at least 0 and less than the training fraction {}, got {}", training,
        validation));
  }
  const auto count = [rows](double part) {
    return static_cast<std::size_t>(std::llround(part * static_cast<double>(rows)));
  };
  if (rows > 0 && count(validation) >= count(training)) {
    throw usage_error(
        fmt::format("a split of {} with a validation fraction of {} leaves no training rows of {}", training,
                    validation, rows));
  }
  if (rows > 0 && validation > 0.0 && count(validation) == 0) {
    throw usage_error(
        fmt::format("a validation fraction of {} leaves no validation row of {}", validation, rows));
  }
  return {count(training), count(validation)};
}

}  // namespace

Split split_rows(std::size_t rows, const SplitOptions& options, std::uint64_t seed) {
  const auto [training, validation] = part_sizes(rows, options);
  RandomStream random(seed, stream_id("split"));
  const std::vector<std::size_t> order = random_permutation(rows, random);
  const auto part = [&order](std::size_t first, std::size_t last) {
    std::vector<std::size_t> chosen(order.begin() + static_cast<std::ptrdiff_t>(first),
                                    order.begin() + static_cast<std::ptrdiff_t>(last));
    std::sort(chosen.begin(), chosen.end());
    return chosen;
  };
  return {.training = part(validation, training),
          .validation = part(0, validation),
          .test = part(training, rows)};
}

std::vector<Split> split_for_trials(std::size_t rows, const SplitOptions& options, std::uint64_t seed,
                                    std::size_t trials) {
  // The fraction is of all rows of the record, of which these are the training fraction.
  const SplitOptions inner{.training_fraction =
                               1.0 - options.validation_fraction / options.training_fraction};
  std::vector<Split> splits;
  for (std::size_t r = 0; r < trials; ++r) {
    Split drawn = split_rows(rows, inner, seed + r);
    if (drawn.test.empty()) {
      throw usage_error(fmt::format("a validation fraction of {} sets none of {} rows aside to choose by",
                                    options.validation_fraction, rows));
    }
    splits.push_back(
        {.training = std::move(drawn.training), .validation = std::move(drawn.test), .test = {}});
  }
  return splits;
}

}  // namespace proofmass
