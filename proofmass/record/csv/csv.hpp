// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/progress.hpp"

namespace proofmass {

enum class DecimalMark : std::uint8_t { automatic, point, comma };

// What becomes of a row in which a meter wrote its mark for a value beyond its range.
enum class OverloadPolicy : std::uint8_t { refuse, leave_out };

struct ReadOptions {
  // Column of Proofmass -> column of the file: {"Ai", "ax"}, from --map Ai=ax. The file's column may be named
  // by its whole header, "ax[m/s^2]", or by its position from 1, "#3". If its header has no unit,
  // "ax[counts]" or "#3[g]" also states the unit.
  std::map<std::string, std::string> rename = {};
  bool require_output = true;  // false for predict, whose records contain inputs only
  std::string encoding = {};   // as find_encoding knows it; empty: found out
  DecimalMark decimal = DecimalMark::automatic;
  OverloadPolicy overload = OverloadPolicy::refuse;
  std::size_t threads = 1;  // at most; the result is the same for any number
};

// Reads a test record in the format of docs/file-formats.md; "-" reads standard input. Values are returned in
// canonical units. What was skipped, converted or assumed is in the record's findings. Throws a bad-data
// Error with file, row, column, what was found and what was expected. Throws a usage Error when `rename`
// contains an unknown column or uses one column of the file twice, and on an unknown encoding.
[[nodiscard]] Dataset read_record(const std::filesystem::path& path, const ReadOptions& options = {});

// The same for long records: reports the megabytes read when the size of the file is known. Throws an Error
// of kind interrupted when it is told to stop.
[[nodiscard]] Dataset read_record(const std::filesystem::path& path, const ReadOptions& options,
                                  Progress& progress);

}  // namespace proofmass
