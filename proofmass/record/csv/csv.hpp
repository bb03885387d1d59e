// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/progress.hpp"

namespace proofmass {

struct ReadOptions {
  // Column of Proofmass -> column of the file: {"Ai", "ax"}, from --map Ai=ax. The file's column may be named
  // by its whole header, "ax[m/s^2]". If its header has no unit, "ax[counts]" also states the unit.
  std::map<std::string, std::string> rename = {};
  bool require_output = true;  // false for predict, whose records contain inputs only
};

// Reads a test record in the format of docs/file-formats.md; "-" reads standard input. Values are returned in
// canonical units. Throws a bad-data Error with file, row, column, what was found and what was expected.
// Throws a usage Error when `rename` contains an unknown column or uses one column of the file twice.
[[nodiscard]] Dataset read_record(const std::filesystem::path& path, const ReadOptions& options = {});

// The same for long records: reports the megabytes read when the size of the file is known. Throws an Error
// of kind interrupted when it is told to stop.
[[nodiscard]] Dataset read_record(const std::filesystem::path& path, const ReadOptions& options,
                                  Progress& progress);

}  // namespace proofmass
