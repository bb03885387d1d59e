// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/output_limits.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "proofmass/assess/diagnosis/record/output_faults.hpp"
#include "proofmass/assess/diagnosis/record/output_resolution.hpp"
#include "proofmass/assess/diagnosis/record/plain_response.hpp"

namespace proofmass {
namespace {

constexpr double kDifferent = 0.01;        // of the range of Ai: inputs that far apart have different outputs
constexpr double kFinelyDifferent = 1e-3;  // likewise, where what noise and nonlinearity make is known
constexpr double kStepsApart = 4.0;        // of the output's rounding, as a fraction of its range
constexpr double kScales = 6.0;            // of the residuals of a linear fit, referred to the input
constexpr std::size_t kLeastClipped = 2;
constexpr std::size_t kLeastHeld = 4;   // rows of one run, or rows of runs of two and more
constexpr double kHeldFraction = 0.02;  // of the rows, where the runs are short

struct OutputRange {
  double least = 0.0;
  double greatest = 0.0;
  [[nodiscard]] double width() const { return greatest - least; }
};

OutputRange range_of(const std::vector<double>& values) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return {.least = *least, .greatest = *greatest};
}

// How far apart in Ai two rows must be for one output in both to say something: farther than rounding, noise
// and nonlinearity bring together.
std::optional<double> telling_distance(const Dataset& record, const std::optional<PlainResponse>& plain,
                                       double different) {
  if (record.rows() < 8 || !record.has(Axis::input)) return std::nullopt;
  const double inputs = range_of(record.along(Axis::input)).width();
  const OutputResolution output = output_resolution(record);
  if (!(inputs > 0.0 && output.range > 0.0)) return std::nullopt;
  const double distance = inputs * std::max(different, kStepsApart * output.step / output.range);
  return plain ? std::max(distance, kScales * plain->scale / plain->scale_factor) : distance;
}

// The rows with exactly this output.
std::vector<std::size_t> rows_at(const Dataset& record, double output) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    if (record.output[row] == output) rows.push_back(row);
  }
  return rows;
}

std::optional<Finding> find_clipping(const Dataset& record, double limit, const char* which, double telling) {
  const std::vector<std::size_t> rows = rows_at(record, limit);
  if (rows.size() < kLeastClipped || spread_over(record.along(Axis::input), rows) <= telling)
    return std::nullopt;
  return Finding{.code = Code::output_clipped,
                 .severity = Severity::warning,
                 .lines = record.lines_of(rows),
                 .figures = {{"count", rows.size()},
                             {"which", std::string(which)},
                             {"value", limit / record.output_unit.to_canonical},
                             {"unit", record.output_unit.symbol}}};
}

// Rows whose output is that of the row before although Ai is another, by runs.
struct HeldRows {
  std::vector<std::size_t> rows;  // the second and later of each run
  std::vector<std::size_t> longest;
};

// Those at an output that is clipped are not held.
HeldRows held_rows(const Dataset& record, const std::vector<double>& limits, double telling) {
  const std::vector<double>& a = record.along(Axis::input);
  HeldRows held;
  std::size_t start = 0;
  const auto close = [&](std::size_t end) {
    if (end - start < 2) return;
    if (std::find(limits.begin(), limits.end(), record.output[start]) != limits.end()) return;
    std::vector<std::size_t> run;
    for (std::size_t row = start; row < end; ++row) run.push_back(row);
    if (spread_over(a, run) <= telling) return;
    held.rows.insert(held.rows.end(), run.begin() + 1, run.end());
    if (run.size() > held.longest.size()) held.longest = std::move(run);
  };
  for (std::size_t row = 1; row < a.size(); ++row) {
    if (record.output[row] == record.output[start]) continue;
    close(row);
    start = row;
  }
  close(a.size());
  return held;
}

std::optional<Finding> find_held(const Dataset& record, const std::vector<double>& limits, double telling) {
  const HeldRows held = held_rows(record, limits, telling);
  const auto fraction = static_cast<double>(held.rows.size()) / static_cast<double>(record.rows());
  const bool many = held.rows.size() >= kLeastHeld && fraction > kHeldFraction;
  if (held.longest.size() < kLeastHeld && !many) return std::nullopt;
  return Finding{.code = Code::output_held,
                 .severity = Severity::warning,
                 .lines = {record.line_of(held.longest.front()), record.line_of(held.longest.back())},
                 .figures = {{"repeats", held.rows.size()},
                             {"longest", held.longest.size()},
                             {"first", record.line_of(held.longest.front())},
                             {"last", record.line_of(held.longest.back())},
                             {"value", record.output[held.longest.front()] / record.output_unit.to_canonical},
                             {"unit", record.output_unit.symbol}}};
}

}  // namespace

std::vector<Finding> find_output_limits(const Dataset& record) {
  std::vector<Finding> findings;
  const std::optional<PlainResponse> plain = plain_response(record);
  const auto telling = telling_distance(record, plain, kDifferent);
  const auto at_limit = plain ? telling_distance(record, plain, kFinelyDifferent) : telling;
  if (!telling || !at_limit) return findings;
  const OutputRange output = range_of(record.output);
  const auto add = [&findings](std::optional<Finding> found) {
    const bool any = found.has_value();
    if (any) findings.push_back(std::move(*found));
    return any;
  };
  std::vector<double> limits;
  if (add(find_clipping(record, output.greatest, "largest", *at_limit))) limits.push_back(output.greatest);
  if (add(find_clipping(record, output.least, "smallest", *at_limit))) limits.push_back(output.least);
  add(find_held(record, limits, *telling));
  if (!plain || !findings.empty()) return findings;
  if (add(find_repeated_output(record, *plain)) || add(find_saturation(record, *plain))) return findings;
  add(find_stuck(record, *plain));
  return findings;
}

}  // namespace proofmass
