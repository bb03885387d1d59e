// SPDX-License-Identifier: Apache-2.0
#include "proofmass/split.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/error.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

// Checks the fractions and returns how many rows train, and how many of those validate.
std::pair<std::size_t, std::size_t> part_sizes(std::size_t rows, const SplitOptions& options) {
  const double training = options.training_fraction;
  if (!(training > 0.0 && training <= 1.0)) {
    throw usage_error(message("split must be more than 0 and at most 1, got {}", training));
  }
  const double validation = options.validation_fraction;
  if (!(validation >= 0.0 && validation < training)) {
    throw usage_error(
        message("the validation fraction must be at least 0 and less than the training fraction {}, got {}",
                training, validation));
  }
  const auto count = [rows](double part) {
    return static_cast<std::size_t>(std::llround(part * static_cast<double>(rows)));
  };
  if (rows > 0 && count(validation) >= count(training)) {
    throw usage_error(message("a split of {} with a validation fraction of {} leaves no training rows of {}",
                              training, validation, rows));
  }
  if (rows > 0 && validation > 0.0 && count(validation) == 0) {
    throw usage_error(
        message("a validation fraction of {} leaves no validation row of {}", validation, rows));
  }
  return {count(training), count(validation)};
}

// The largest fraction, in as few digits as do, that leaves a row for testing: 0.93 of 15 rows.
double largest_fraction(std::size_t rows) {
  double scale = 10.0;
  while (scale < static_cast<double>(rows)) scale *= 10.0;
  return std::floor(scale * static_cast<double>(rows - 1) / static_cast<double>(rows)) / scale;
}

// A fraction below 1 asks for rows to test on. One row is too few for anything, which is said elsewhere.
void require_test_row(std::size_t rows, double fraction, std::size_t training) {
  if (rows < 2 || fraction >= 1.0 || training < rows) return;
  const std::string most = fmt::format("{}", largest_fraction(rows));
  throw Error(ErrorKind::usage,
              message("a split of {} leaves none of {} rows to test on: it must be 1, to fit all rows, or at "
                      "most {}",
                      fraction, rows, most),
              {{"split", "1"}, {"split", most}});
}

Split drawn_rows(std::size_t rows, const SplitOptions& options, std::uint64_t seed) {
  const auto [training, validation] = part_sizes(rows, options);
  if (training == rows && validation == 0) {
    Split all;
    all.training.resize(rows);
    std::iota(all.training.begin(), all.training.end(), std::size_t{0});
    return all;
  }
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

// How many mounts, in that order, have nearest to `rows` rows; at least `least` and at most `most`.
std::size_t mounts_near(const std::vector<std::vector<std::size_t>>& members,
                        const std::vector<std::size_t>& order, std::size_t rows, std::size_t least,
                        std::size_t most) {
  std::size_t count = 0;
  std::size_t sum = 0;
  while (count < most) {
    const std::size_t next = sum + members[order[count]].size();
    const bool nearer = next <= rows || next - rows < rows - sum;
    if (count >= least && !(sum < rows && nearer)) break;
    sum = next;
    ++count;
  }
  return count;
}

// Moves mounts of the first `used` to the front, taken in order where they bring their rows nearer to `rows`:
// at least one, the smallest where none does, and not all. Returns how many.
std::size_t move_validating(const std::vector<std::vector<std::size_t>>& members,
                            std::vector<std::size_t>& order, std::size_t used, std::size_t rows) {
  std::size_t count = 0;
  std::size_t sum = 0;
  const auto move = [&](std::size_t k) {
    sum += members[order[k]].size();
    std::rotate(order.begin() + static_cast<std::ptrdiff_t>(count),
                order.begin() + static_cast<std::ptrdiff_t>(k),
                order.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    ++count;
  };
  for (std::size_t k = 0; k < used && count + 1 < used; ++k) {
    const std::size_t next = sum + members[order[k]].size();
    if (next <= rows || next - rows < rows - std::min(rows, sum)) move(k);
  }
  if (count > 0) return count;
  const auto smaller = [&members](std::size_t a, std::size_t b) {
    return members[a].size() < members[b].size();
  };
  move(static_cast<std::size_t>(
      std::min_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(used), smaller) -
      order.begin()));
  return count;
}

std::vector<std::size_t> rows_of(const std::vector<std::vector<std::size_t>>& members,
                                 const std::vector<std::size_t>& order, std::size_t first, std::size_t last) {
  std::vector<std::size_t> rows;
  for (std::size_t k = first; k < last; ++k)
    rows.insert(rows.end(), members[order[k]].begin(), members[order[k]].end());
  std::sort(rows.begin(), rows.end());
  return rows;
}

}  // namespace

Split split_rows(std::size_t rows, const SplitOptions& options, std::uint64_t seed) {
  require_test_row(rows, options.training_fraction, part_sizes(rows, options).first);
  return drawn_rows(rows, options, seed);
}

Split split_mounts(std::span<const std::string> mounts, const SplitOptions& options, std::uint64_t seed) {
  const auto [training, validation] = part_sizes(mounts.size(), options);
  const std::vector<std::vector<std::size_t>> members = rows_by_mount(mounts);
  const std::size_t set_aside = options.training_fraction < 1.0 ? 1 : 0;
  const std::size_t parts = 1 + set_aside + (validation > 0 ? std::size_t{1} : 0);
  if (members.size() < parts) {
    throw usage_error(
        message("whole mounts cannot be set aside: the record has {} and {} parts need one each",
                members.size(), parts));
  }
  RandomStream random(seed, stream_id("split mounts"));
  std::vector<std::size_t> order = random_permutation(members.size(), random);
  // Whatever validates: every method sees the same test rows.
  const std::size_t least = members.size() > 2 ? 2 : 1;
  const std::size_t used = set_aside > 0
                               ? mounts_near(members, order, training, least, members.size() - set_aside)
                               : members.size();
  const std::size_t validating = validation > 0 ? move_validating(members, order, used, validation) : 0;
  return {.training = rows_of(members, order, validating, used),
          .validation = rows_of(members, order, 0, validating),
          .test = rows_of(members, order, used, members.size())};
}

namespace {

// Trials on training rows: the validation fraction is of all rows of the record.
SplitOptions inner(const SplitOptions& options) {
  return {.training_fraction = 1.0 - options.validation_fraction / options.training_fraction};
}

// What would be for testing validates.
template <typename Draw>
std::vector<Split> trials_of(const SplitOptions& options, std::size_t rows, std::uint64_t seed,
                             std::size_t trials, const Draw& draw) {
  std::vector<Split> splits;
  for (std::size_t r = 0; r < trials; ++r) {
    Split drawn = draw(seed + r);
    if (drawn.test.empty()) {
      throw usage_error(message("a validation fraction of {} sets none of {} rows aside to choose by",
                                options.validation_fraction, rows));
    }
    splits.push_back(
        {.training = std::move(drawn.training), .validation = std::move(drawn.test), .test = {}});
  }
  return splits;
}

}  // namespace

std::vector<Split> split_for_trials(std::size_t rows, const SplitOptions& options, std::uint64_t seed,
                                    std::size_t trials) {
  return trials_of(options, rows, seed, trials,
                   [&](std::uint64_t own) { return drawn_rows(rows, inner(options), own); });
}

std::vector<Split> split_mounts_for_trials(std::span<const std::string> mounts, const SplitOptions& options,
                                           std::uint64_t seed, std::size_t trials) {
  return trials_of(options, mounts.size(), seed, trials,
                   [&](std::uint64_t own) { return split_mounts(mounts, inner(options), own); });
}

}  // namespace proofmass
