// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proofmass/record/columns.hpp"
#include "proofmass/record/csv/csv.hpp"
#include "proofmass/record/csv/header.hpp"

namespace proofmass {

// A column of Proofmass and its place in the file.
struct PlacedColumn {
  Column column = Column::Ai;
  std::size_t index = 0;  // of the field in a line, from 0
  Unit unit;
  bool declared = true;  // the file says the unit
  std::string header;    // as written in the file, for messages
};

// "#3" is the third column, place 2; nothing for other names.
[[nodiscard]] std::optional<std::size_t> position_of(std::string_view name);

// Whether a header has a column for one of Proofmass's, by its name, by a usual other one, or as renamed;
// true of a column renamed by a position that the header has.
[[nodiscard]] bool has_column(const Header& header, Column column, const ReadOptions& options);

// Columns of a header that are not placed, and the name of Proofmass's that each looks like a slip of.
[[nodiscard]] std::vector<IgnoredColumn> ignored_columns(const Header& header, const ReadOptions& options,
                                                         const std::vector<PlacedColumn>& placed);

// Finds Proofmass's columns in a header, by name or as renamed. Unknown columns are ignored, and so are
// uncertainties of columns that the file does not have. Throws a bad-data Error on a missing or duplicate
// column, an unknown unit, or units that do not agree. Throws a usage Error on an invalid renaming.
[[nodiscard]] std::vector<PlacedColumn> lay_out(const Header& header, const ReadOptions& options);

// The same before their units are brought into agreement: the cells of a record may say some.
[[nodiscard]] std::vector<PlacedColumn> place_columns(const Header& header, const ReadOptions& options);

}  // namespace proofmass
