// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/output_faults.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace proofmass {
namespace {

constexpr double kShort = 0.015;  // of the range of the outputs, that a row asks for beyond their end
constexpr double kManyScales = 20.0;
constexpr double kFlat = 0.5;  // output over expected output, beyond the end
constexpr std::size_t kLeastSaturated = 2;
constexpr std::size_t kStuckRows = 4;  // in sequence; three of a record that has few
constexpr std::size_t kFewRows = 60;
constexpr double kUnmoved = 0.2;  // of the change that the inputs ask for
constexpr std::size_t kLeastRepeated = 4;

// How the outputs of these rows change with what is expected of them; zero where that is one value.
double slope_over(const std::vector<std::size_t>& rows, const std::vector<double>& expected,
                  const std::vector<double>& output) {
  const auto n = static_cast<double>(rows.size());
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (const std::size_t row : rows) {
    mean_x += expected[row] / n;
    mean_y += output[row] / n;
  }
  double xx = 0.0;
  double xy = 0.0;
  for (const std::size_t row : rows) {
    xx += (expected[row] - mean_x) * (expected[row] - mean_x);
    xy += (expected[row] - mean_x) * (output[row] - mean_y);
  }
  return xx > 0.0 ? xy / xx : 0.0;
}

// The rows that ask for more than the outputs' end on one side, `least` of them or more; `sign` is 1 for the
// largest, -1 for the smallest.
std::vector<std::size_t> rows_beyond(const Dataset& record, const PlainResponse& plain, double sign,
                                     std::size_t least) {
  double end = sign * record.output.front();
  for (const double e : record.output) end = std::max(end, sign * e);
  const double margin = std::max(kShort * plain.range, kManyScales * plain.scale);
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    if (sign * plain.expected[row] > end + margin) rows.push_back(row);
  }
  if (rows.size() < least) return {};
  const bool curved =
      spread_over(plain.expected, rows) > margin && slope_over(rows, plain.expected, record.output) > kFlat;
  return curved ? std::vector<std::size_t>() : rows;
}

struct RowRun {
  std::size_t first = 0;
  std::size_t last = 0;  // not included
  [[nodiscard]] std::size_t size() const { return last - first; }
  [[nodiscard]] std::vector<std::size_t> rows() const {
    std::vector<std::size_t> all(size());
    std::iota(all.begin(), all.end(), first);
    return all;
  }
};

// How far apart the expected outputs of these rows are when one of them, whose input may be wrong, is left
// out.
double spread_without_one(const std::vector<double>& expected, std::span<const std::size_t> rows) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const std::size_t row : rows) values.push_back(expected[row]);
  std::sort(values.begin(), values.end());
  return std::min(values.back() - values[1], values[values.size() - 2] - values.front());
}

bool is_stuck(const Dataset& record, const PlainResponse& plain, const RowRun& run) {
  const std::vector<std::size_t> rows = run.rows();
  const double asked = spread_without_one(plain.expected, rows);
  return asked > plain.telling() && spread_over(record.output, rows) < kUnmoved * asked;
}

// Joined from stretches of so many rows, in each of which the output is stuck.
RowRun longest_stuck(const Dataset& record, const PlainResponse& plain, std::size_t stretch) {
  RowRun longest;
  RowRun run;
  for (std::size_t first = 0; first + stretch <= record.rows(); ++first) {
    if (!is_stuck(record, plain, {first, first + stretch})) continue;
    run = first < run.last ? RowRun{run.first, first + stretch} : RowRun{first, first + stretch};
    if (run.size() > longest.size()) longest = run;
  }
  return longest;
}

}  // namespace

std::optional<Finding> find_saturation(const Dataset& record, const PlainResponse& plain) {
  // One row at an end may be wrong itself; one at each end is the range.
  const bool both =
      !rows_beyond(record, plain, 1.0, 1).empty() && !rows_beyond(record, plain, -1.0, 1).empty();
  for (const double sign : {1.0, -1.0}) {
    std::vector<std::size_t> rows = rows_beyond(record, plain, sign, both ? 1 : kLeastSaturated);
    if (rows.empty()) continue;
    double end = sign * record.output.front();
    double most = 0.0;
    for (const double e : record.output) end = std::max(end, sign * e);
    for (const std::size_t row : rows) most = std::max(most, sign * plain.expected[row]);
    if (both) {
      const std::vector<std::size_t> others = rows_beyond(record, plain, -sign, 1);
      rows.insert(rows.end(), others.begin(), others.end());
      std::sort(rows.begin(), rows.end());
    }
    const Unit& unit = record.output_unit;
    return Finding{.code = Code::output_saturated,
                   .severity = Severity::warning,
                   .lines = record.lines_of(rows),
                   .figures = {{"count", rows.size()},
                               {"value", sign * end / unit.to_canonical},
                               {"expected", sign * most / unit.to_canonical},
                               {"unit", unit.symbol}}};
  }
  return std::nullopt;
}

std::optional<Finding> find_stuck(const Dataset& record, const PlainResponse& plain) {
  const std::size_t stretch = record.rows() < kFewRows ? kStuckRows - 1 : kStuckRows;
  const RowRun longest = longest_stuck(record, plain, stretch);
  if (longest.size() == 0) return std::nullopt;
  const std::vector<std::size_t> rows = longest.rows();
  const Unit& unit = record.output_unit;
  const double to_declared = 1.0 / std::abs(unit.to_canonical);
  return Finding{.code = Code::output_stuck,
                 .severity = Severity::warning,
                 .lines = {record.line_of(longest.first), record.line_of(longest.last - 1)},
                 .figures = {{"longest", longest.size()},
                             {"first", record.line_of(longest.first)},
                             {"last", record.line_of(longest.last - 1)},
                             {"value", record.output[longest.first] / unit.to_canonical},
                             {"spread", spread_over(record.output, rows) * to_declared},
                             {"expected", spread_over(plain.expected, rows) * to_declared},
                             {"unit", unit.symbol}}};
}

std::optional<Finding> find_repeated_output(const Dataset& record, const PlainResponse& plain) {
  const CommonOutput& common = plain.common;
  if (common.count < kLeastRepeated) return std::nullopt;
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    if (record.output[row] == common.value) rows.push_back(row);
  }
  if (!(spread_over(plain.expected, rows) > plain.telling())) return std::nullopt;
  return Finding{.code = Code::output_repeated,
                 .severity = Severity::warning,
                 .lines = record.lines_of(rows),
                 .figures = {{"count", rows.size()},
                             {"value", common.value / record.output_unit.to_canonical},
                             {"unit", record.output_unit.symbol}}};
}

}  // namespace proofmass
