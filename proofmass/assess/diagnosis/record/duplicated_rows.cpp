// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/duplicated_rows.hpp"

#include <algorithm>
#include <boost/math/distributions/poisson.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "proofmass/assess/diagnosis/record/output_resolution.hpp"
#include "proofmass/assess/diagnosis/record/repeats.hpp"
#include "proofmass/assess/diagnosis/record/term_space.hpp"
#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"
#include "proofmass/numeric/regression/robust_loss.hpp"

namespace proofmass {
namespace {

constexpr double kUnlikely = 1e-6;
constexpr std::size_t kLeastAllSame = 3;  // rows that were repeated, and all of them with the same output
constexpr double kUnlikelyAllSame = 1e-3;
constexpr double kContinuous = 0.45;  // of the rows: all of them pasted twice leaves half
constexpr double kUnequalNoise =
    3.0;  // rows with less noise than the median's have the same output more often
constexpr double kRoundingNoise = 0.6;  // of the step: rounding alone has 0.29
constexpr double kLeastOfRounding = 0.1;
constexpr double kFineOutput =
    1e-4;  // step over range: repeated rows cannot all have the same output by rounding

struct Pairs {
  std::size_t rows = 0;             // with the inputs of an earlier row
  std::size_t count = 0;            // of a row and an earlier one with its inputs
  std::vector<std::size_t> same;    // rows that have an earlier one's output too
  std::vector<double> differences;  // of the outputs of rows and the last ones before with their inputs
  std::size_t first_original = 0;   // what the first of `same` repeats
  bool in_sequence = true;          // all rows with the inputs of an earlier one stand below one of these
};

// Whether hardly two rows have the same value along the record's first axis, as in random directions: then
// rows with the same inputs are not planned.
bool has_continuous_inputs(const Dataset& record) {
  std::vector<double> values = record.along(record.axes().front());
  std::sort(values.begin(), values.end());
  const auto distinct = static_cast<double>(std::unique(values.begin(), values.end()) - values.begin());
  return distinct >= kContinuous * static_cast<double>(record.rows());
}

Pairs pairs_of(const Dataset& record) {
  std::vector<const std::vector<double>*> columns;
  for (const Axis axis : record.axes()) columns.push_back(&record.along(axis));
  const std::vector<std::size_t> set_up = earlier_equals(record.rows(), columns);
  Pairs pairs;
  bool any = false;
  for (std::size_t row = 0; row < set_up.size(); ++row) any = any || set_up[row] != row;
  if (!any) return pairs;
  columns.push_back(&record.output);
  const std::vector<std::size_t> equal = earlier_equals(record.rows(), columns);
  std::vector<std::size_t> before(record.rows(), 0);  // rows with the same inputs
  for (std::size_t row = 0; row < record.rows(); ++row) {
    if (set_up[row] == row) continue;
    before[row] = before[set_up[row]] + 1;
    ++pairs.rows;
    pairs.count += before[row];
    pairs.in_sequence = pairs.in_sequence && set_up[row - 1] == set_up[row];
    const double difference = record.output[row] - record.output[set_up[row]];
    if (difference != 0.0) pairs.differences.push_back(difference);
    if (equal[row] == row) continue;
    if (pairs.same.empty()) pairs.first_original = equal[row];
    pairs.same.push_back(row);
  }
  return pairs;
}

// Where all rows with the same inputs have the same output, the noise is what every term of the static model
// leaves.
double scale_beyond_terms(const Dataset& record) {
  const Dataset rows = record.select(thinned_rows(record.rows()));
  const Matrix basis = orthonormal_rows(rows, full_terms());
  if (rows.rows() < 2 * basis.columns()) return 0.0;
  return median_scale(beyond_columns(basis, rows.output), basis.columns());
}

// Whether what the terms leave is rounding of the outputs: levels at equal distances have outputs on a grid
// of their own, from which they differ by far less.
bool is_rounded(const Dataset& record, const OutputResolution& resolution) {
  const double scale = scale_beyond_terms(record);
  const auto by = [scale](double step) {
    return scale > kLeastOfRounding * step && scale < kRoundingNoise * step;
  };
  return by(resolution.step) || by(resolution.decimals);
}

// Whether outputs of one set-up that differ do so by the step they are written in: readings to either side of
// where it is rounded.
bool by_one_step(const Pairs& pairs, double step) {
  return std::all_of(pairs.differences.begin(), pairs.differences.end(),
                     [step](double difference) { return std::abs(difference) < 1.5 * step; });
}

// Whether rounding explains that so many of the pairs have one output.
bool explained_by_rounding(const Pairs& pairs, const Dataset& record) {
  const OutputResolution resolution = output_resolution(record);
  const bool planned = 2 * pairs.rows >= record.rows();
  if (pairs.differences.empty()) {
    // Levels that nothing else repeats: a second pass over them, where the noise is below the output's step.
    if (has_continuous_inputs(record) && !pairs.in_sequence) return planned && is_rounded(record, resolution);
    if (planned && resolution.step >= kFineOutput * resolution.range) return true;
    if (planned) return scale_beyond_terms(record) < kRoundingNoise * resolution.step;
  }
  const bool one_step = planned && !pairs.differences.empty() && by_one_step(pairs, resolution.step);
  if (one_step && is_rounded(record, resolution)) return true;
  const double sd = pairs.differences.empty() ? std::numbers::sqrt2 * scale_beyond_terms(record)
                                              : median_scale(pairs.differences, 0);
  if (!(sd > 0.0)) return true;
  const double same = std::min(1.0, resolution.step / (sd * std::sqrt(2.0 * std::numbers::pi)));
  const bool all_same = pairs.differences.empty() && pairs.same.size() >= kLeastAllSame;
  const double expected = (all_same ? 1.0 : kUnequalNoise) * same * static_cast<double>(pairs.count);
  if (expected <= 0.0) return false;
  const boost::math::poisson_distribution<double> chance(expected);
  const auto observed = static_cast<double>(pairs.same.size());
  return boost::math::cdf(boost::math::complement(chance, observed - 1.0)) >
         (all_same ? kUnlikelyAllSame : kUnlikely);
}

}  // namespace

std::optional<Finding> find_duplicated_rows(const Dataset& record) {
  if (record.rows() < 2 || record.axes().empty()) return std::nullopt;
  const Pairs pairs = pairs_of(record);
  if (pairs.same.empty() || explained_by_rounding(pairs, record)) return std::nullopt;
  return Finding{.code = Code::rows_duplicated,
                 .severity = Severity::warning,
                 .lines = record.lines_of(pairs.same),
                 .figures = {{"count", pairs.same.size()},
                             {"first", record.line_of(pairs.same.front())},
                             {"original", record.line_of(pairs.first_original)}}};
}

}  // namespace proofmass
