// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/mount_offsets.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace proofmass {
namespace {

constexpr double kUnlikelyOffset = 1e-4;  // of all mounts together
constexpr std::size_t kLeastMountRows = 3;
constexpr double kLeastOffsetLeft = 0.01;  // of an offset: less lies within the terms

struct Offset {
  std::string mount;
  double mean = 0.0;    // of the residuals, in the output's canonical unit
  double errors = 0.0;  // of their sum, in standard errors
  double probability = 1.0;
};

// The sum of the bounded residuals of a mount, against the noise of all rows and, lest a mount with more of
// it than others looks like an offset, against that of the mount's own rows.
Offset offset_of(const FittedRows& rows, const std::string& mount, const std::vector<std::size_t>& members) {
  const auto n = static_cast<double>(members.size());
  double sum = 0.0;
  double squares = 0.0;
  double mean = 0.0;
  for (const std::size_t row : members) {
    sum += rows.bounded()[row];
    squares += rows.bounded()[row] * rows.bounded()[row];
    mean += rows.residuals()[row] / n;
  }
  double within_terms = 0.0;
  for (std::size_t c = 0; c < rows.basis().columns(); ++c) {
    double part = 0.0;
    for (const std::size_t row : members) part += rows.basis()(row, c);
    within_terms += part * part;
  }
  const double left = n - within_terms;
  if (!(left > kLeastOffsetLeft * n)) return {};
  const double pooled = sum / std::sqrt(rows.bounded_variance() * left);
  const double own_variance = (squares - sum * sum / n) / (n - 1.0);
  const double own = own_variance > 0.0 ? sum / std::sqrt(n * own_variance) : pooled;
  return {.mount = mount,
          .mean = mean,
          .errors = pooled,
          .probability = std::max(student_probability(pooled, static_cast<double>(rows.dof())),
                                  student_probability(own, n - 1.0))};
}

}  // namespace

std::optional<Finding> find_mount_offsets(const FittedRows& rows) {
  const Dataset& record = rows.record();
  std::map<std::string, std::vector<std::size_t>> members;
  for (std::size_t row = 0; row < record.mount.size(); ++row) members[record.mount[row]].push_back(row);
  if (members.size() < 2) return std::nullopt;
  const auto mounts = static_cast<double>(members.size());
  Offset strongest;
  std::size_t count = 0;
  for (const auto& [mount, own] : members) {
    if (own.size() < kLeastMountRows) continue;
    const Offset offset = offset_of(rows, mount, own);
    if (offset.probability * mounts < kUnlikelyOffset) ++count;
    if (offset.probability < strongest.probability) strongest = offset;
  }
  if (count == 0) return std::nullopt;
  const Unit& unit = record.output_unit;
  return Finding{.code = Code::residuals_follow_mount,
                 .severity = Severity::warning,
                 .figures = {{"count", count},
                             {"total", members.size()},
                             {"mount", strongest.mount},
                             {"mean", strongest.mean / unit.to_canonical},
                             {"unit", unit.symbol},
                             {"errors", std::abs(strongest.errors)}}};
}

}  // namespace proofmass
