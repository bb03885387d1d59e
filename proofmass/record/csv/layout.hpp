// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "proofmass/record/columns.hpp"
#include "proofmass/record/csv/csv.hpp"
#include "proofmass/record/csv/header.hpp"

namespace proofmass {

// A column of the contract and where the file holds it.
struct PlacedColumn {
  Column column = Column::Ai;
  std::size_t index = 0;  // of the field in a line, from 0
  Unit unit;
  std::string header;  // as the file writes it, for messages
};

// Finds the columns of the contract in a header, by name or as renamed; columns that the contract does not
// know are left out, and so are uncertainties of columns that the file lacks. Throws a bad-data Error on a
// missing or duplicate column, an unknown unit, or units that do not agree; a usage Error on a renaming that
// makes no sense.
[[nodiscard]] std::vector<PlacedColumn> lay_out(const Header& header, const ReadOptions& options);

}  // namespace proofmass
