// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/time_order.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace proofmass {
namespace {

constexpr double kRare = 0.05;  // of the rows: a clock that is coarser than the rows stands still in more
constexpr double kLongStretch = 0.10;  // of the rows at one time
constexpr std::size_t kLeastAtOneTime = 5;
constexpr double kFewOutOfOrder = 0.1;  // of the rows

struct Steps {
  std::vector<std::size_t> backwards;  // rows whose time is not after those above and before those below
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

// The fewest rows without which time does not fall: of a mark among readings it is the mark, and not the row
// below it. What stays is a longest ascending sequence (Fredman, Discrete Mathematics 11, 1975).
std::vector<std::size_t> rows_out_of_order(const std::vector<double>& time) {
  std::vector<std::size_t> ends;  // of the sequences of each length, the row where the earliest ends
  std::vector<std::size_t> before(time.size(), time.size());
  for (std::size_t row = 0; row < time.size(); ++row) {
    const auto at = std::upper_bound(ends.begin(), ends.end(), time[row],
                                     [&time](double t, std::size_t end) { return t < time[end]; });
    if (at != ends.begin()) before[row] = *(at - 1);
    if (at == ends.end()) {
      ends.push_back(row);
    } else {
      *at = row;
    }
  }
  std::vector<bool> stays(time.size(), false);
  for (std::size_t row = ends.back(); row < time.size(); row = before[row]) stays[row] = true;
  std::vector<std::size_t> out;
  for (std::size_t row = 0; row < time.size(); ++row) {
    if (!stays[row]) out.push_back(row);
  }
  return out;
}

// Of a few marks these; where whole parts are out of order, the rows where they begin.
void name_marks(const std::vector<double>& time, std::vector<std::size_t>& backwards) {
  std::vector<std::size_t> out = rows_out_of_order(time);
  if (static_cast<double>(out.size()) <= kFewOutOfOrder * static_cast<double>(time.size()))
    backwards = std::move(out);
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
  if (!steps.backwards.empty() && record.mount.empty()) name_marks(record.time, steps.backwards);
  if (!steps.backwards.empty()) return disorder(Code::time_backwards, record, steps.backwards);
  if (steps.still.empty()) return std::nullopt;
  const auto rows = static_cast<double>(record.rows());
  const bool rare = static_cast<double>(steps.still.size()) <= kRare * rows;
  const bool long_stretch =
      steps.longest >= kLeastAtOneTime && static_cast<double>(steps.longest) > kLongStretch * rows;
  if (!rare && !long_stretch) return std::nullopt;
  return disorder(Code::time_standing, record, steps.still);
}

}  // namespace proofmass
