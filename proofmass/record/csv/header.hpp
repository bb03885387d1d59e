// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "proofmass/record/csv/lines.hpp"

namespace proofmass {

// One column of a header: `Ai [m/s^2]` has the name "Ai" and the unit "m/s^2".
struct HeaderCell {
  std::string text;  // whole, without quotes and surrounding blanks
  std::string name;
  std::optional<std::string> unit;
};

struct Header {
  std::string file;
  std::size_t row = 0;
  char separator = ',';
  std::vector<HeaderCell> cells;
};

[[nodiscard]] HeaderCell parse_header_cell(const std::string& text);

// Reads lines up to and including the header: the first that is neither blank nor a comment. Throws a
// bad-data Error when there is none, or when it has more than 1000 columns or a field with unmatched quotes.
[[nodiscard]] Header read_header(LineReader& lines);

}  // namespace proofmass
