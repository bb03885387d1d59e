// SPDX-License-Identifier: Apache-2.0
// Methods side by side on one record.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "proofmass/core/run.hpp"
#include "proofmass/core/static_model.hpp"
#include "proofmass/identify/options/method_info.hpp"

namespace proofmass {

// Mean and standard deviation over repeats; the latter is absent with one repeat.
struct Spread {
  double mean = 0.0;
  std::optional<double> sd;
};
[[nodiscard]] Spread spread_of(std::span<const double> values);

// Metrics of one part of the record over the repeats.
struct MetricSpreads {
  Spread mae, mse, rmse;
  std::optional<Spread> mape_percent, r2;  // absent when some repeat lacks them
  Spread n, mape_rows;                     // rows, and those that mape_percent is over
};

// How far the coefficients are from a known truth, over terms and repeats.
struct TruthScore {
  std::optional<double>
      rms_over_standard_error;           // rms of error / standard error; absent without standard errors
  std::optional<double> rms_over_bound;  // rms of error / Cramér-Rao bound; absent without a bound
  double largest_error = 0.0;            // |error|, in the coefficient's unit
  Term largest_term = Term::K0;          // where
};

// What one method came to: its runs, one a repeat, and their summary.
struct Contestant {
  std::string method;
  std::vector<Run> runs;
  std::vector<double> seconds;  // of each run, wall clock
  std::optional<MetricSpreads> train, test;
  Spread time;                       // s
  std::optional<Spread> iterations;  // as in Diagnostics; absent for direct solutions
  std::optional<TruthScore> truth;
};

struct Comparison {
  std::string input;
  std::uint64_t seed = 0;  // of the first repeat; repeat r uses seed + r, for all methods alike
  std::size_t repeats = 1;
  double training_fraction = kTrainingFraction;
  std::vector<Contestant> contestants;
  std::vector<Finding> findings;     // on the record and its truth
  std::optional<StaticModel> truth;  // where it is known
};

// The terms that some method was asked for, in canonical order.
[[nodiscard]] TermList terms_of(const Comparison& comparison);

// Mean figures of one method over those of another, as the paper gives its cost; absent where either lacks
// the figure or the other's is zero.
struct CostRatios {
  std::optional<double> iterations, time, test_mse;
};
[[nodiscard]] CostRatios ratios_to(const Contestant& reference, const Contestant& contestant);

// A finding on a method, and in how many repeats it was made.
struct Occurrence {
  Finding finding;  // as first made
  std::size_t repeats = 0;
};

// Of one severity, in the order in which they were first made. Those of one code and terms are the same,
// whatever their figures.
[[nodiscard]] std::vector<Occurrence> occurrences(const Contestant& contestant, Severity severity);

// Fills the summary of a contestant from its runs and times.
void summarise(Contestant& contestant);

// Coefficients against the truth (same units); one left out by choice is an estimate of zero, without a
// standard error, and one that the rows cannot identify does not count. `bound` has the Cramér-Rao bound of
// each run's coefficients that count, a vector a run in the order of its coefficients, or is empty.
[[nodiscard]] TruthScore score_against(const StaticModel& truth, std::span<const Run> runs,
                                       std::span<const std::vector<double>> bound);

}  // namespace proofmass
