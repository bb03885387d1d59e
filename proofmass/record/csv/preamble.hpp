// SPDX-License-Identifier: Apache-2.0
// What stands above the data of a record: lines of the instrument, the header, a line of units.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proofmass/core/message.hpp"
#include "proofmass/record/csv/csv.hpp"
#include "proofmass/record/csv/header.hpp"
#include "proofmass/record/csv/lines.hpp"

namespace proofmass {

// What a file without a header lacks, for messages.
[[nodiscard]] Message expected_header();

struct Preamble {
  Header header;                         // with the units of the line of units, if there is one
  std::vector<std::size_t> skipped;      // numbers of the lines before it that are neither blank nor comments
  std::optional<std::size_t> units_row;  // number of the line of units
  bool header_in_comment = false;
  std::size_t data_begin = 0;  // byte of the chunk where the lines of data begin
  std::size_t data_line = 1;   // number of the line there
};

// Finds the header in a file's first chunk: the first line that names the columns that the options need, be
// it in a comment; by the lines of numbers below it where columns are named by position. Where no line is the
// header, the one that looks most like it is taken, for the message about what it lacks. Throws a bad-data
// Error when there is nothing but comments and blank lines, or numbers alone.
[[nodiscard]] Preamble read_preamble(const std::string& file, const Chunk& chunk, const ReadOptions& options);

}  // namespace proofmass
