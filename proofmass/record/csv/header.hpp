// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace proofmass {

// One column of a header: `Ai [m/s^2]` has the name "Ai" and the unit "m/s^2".
struct HeaderCell {
  std::string text;  // whole, without quotes and surrounding blanks
  std::string name;
  std::optional<std::string> unit;
  bool loose = false;  // the unit was found at the end of its name: `Ai_g`
};

// How the fields of a line are told apart. A blank as separator stands for any run of blanks and tabs; the
// lines are then read with tabs in their place (separated_by_marks).
struct Separation {
  char mark = ',';
  bool blanks = false;
  bool fullwidth = false;  // commas and semicolons are full-width: U+FF0C, U+FF1B
};

struct Header {
  std::string file;
  std::size_t row = 0;
  Separation separation;
  std::vector<HeaderCell> cells;
  std::string text;  // the line as written
};

// Understands a unit in brackets, in parentheses (full-width ones too), and, where it is a unit that is
// known, after " / ", " in ", "," or "_": `Ai[g]`, `Ai (g)`, `Ai / g`, `Ai in g`, `Ai, g`, `Ai_g`.
[[nodiscard]] HeaderCell parse_header_cell(std::string_view text);

// The cells of a header line. Throws a bad-data Error when it has more than 1000 columns or a field with
// unmatched quotes. `separator`: said by the file itself; otherwise it is found out.
[[nodiscard]] Header parse_header(const std::string& file, std::string_view line, std::size_t row,
                                  std::optional<char> separator);

// The line of a record as its header says that it is separated: blanks as tabs, full-width punctuation as
// ASCII.
[[nodiscard]] std::string separated_by_marks(std::string_view line, const Separation& separation);

}  // namespace proofmass
