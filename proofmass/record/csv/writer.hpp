// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "proofmass/core/dataset.hpp"

namespace proofmass {

enum class RecordUnits {
  canonical,  // as the data set holds them: reading gives the same bits
  declared,   // as the record declared them: the same bits for values that came from a record in these units,
              // otherwise within two units in the last place
};

struct WriteOptions {
  RecordUnits units = RecordUnits::canonical;
  std::vector<std::string> comments = {};  // lines for the top of the file, without "#"
};

// Writes a record in the format of docs/file-formats.md: every column of the data set, in the order Ai Ao Ap
// E sigma_E sigma_Ai sigma_Ao sigma_Ap mount T t, with units in the header, each number in the fewest digits
// that give the same double. The same data give the same bytes. Throws a usage Error on text that does not
// fit on a line, and on other axes without Ai.
void write_record(std::ostream& out, const Dataset& record, const WriteOptions& options = {});

// The same, to a file that appears when it is complete (see AtomicFile).
void write_record(const std::filesystem::path& path, const Dataset& record, const WriteOptions& options = {});

}  // namespace proofmass
