// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/time_order.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace proofmass {
namespace {

constexpr double kRare = 0.05;  // of the rows: a clock that is coarser than the rows stands still in more
constexpr double kLongStretch = 0.10;  // of the rows at one time
constexpr std::size_t kLeastStretch = 5;

struct Steps {
  std::vector<std::size_t> backwards;  // rows whose time is before that of the row above
  std::vector<std::size_t> still;      // or the same
  std::size_t longest = 1;             // rows with one time in sequence
};

Steps steps_of(const std::vector<double>& time) {
  Steps steps;
  std::size_t stretch = 1;
  for (std::size_t row = 1; row < time.size(); ++row) {
    stretch = time[row] == time[row - 1] ? stretch + 1 : 1;
    steps.longest = std::max(steps.longest, stretch);
    if (time[row] < time[row - 1]) steps.backwards.push_back(row);
    if (time[row] == time[row - 1]) steps.still.push_back(row);
  }
  return steps;
}

Finding disorder(Code code, const Dataset& record, const std::vector<std::size_t>& rows) {
  return {.code = code,
          .severity = Severity::warning,
          .lines = record.lines_of(rows),
          .figures = {{"count", rows.size()}, {"total", record.rows()}}};
}

// A clock that starts anew with a mount does not run backwards.
void leave_out_first_of_mounts(const Dataset& record, std::vector<std::size_t>& rows) {
  for (const std::vector<std::size_t>& members : rows_by_mount(record.mount))
    std::erase(rows, members.front());
}

}  // namespace

std::optional<Finding> find_time_disorder(const Dataset& record) {
  if (record.time.size() < 2) return std::nullopt;
  Steps steps = steps_of(record.time);
  if (!steps.backwards.empty()) leave_out_first_of_mounts(record, steps.backwards);
  if (!steps.backwards.empty()) return disorder(Code::time_backwards, record, steps.backwards);
  if (steps.still.empty()) return std::nullopt;
  const auto rows = static_cast<double>(record.rows());
  const bool rare = static_cast<double>(steps.still.size()) <= kRare * rows;
  const bool long_stretch =
      steps.longest >= kLeastStretch && static_cast<double>(steps.longest) > kLongStretch * rows;
  if (!rare && !long_stretch) return std::nullopt;
  return disorder(Code::time_standing, record, steps.still);
}

}  // namespace proofmass
