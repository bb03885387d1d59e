// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "proofmass/record/csv/layout.hpp"

namespace proofmass {

// Interprets a column of the file as a column of Proofmass. Its unit is the one written, or else the default:
// g, degC, s; for an uncertainty the unit of its quantity, which settle_units() supplies. Throws a bad-data
// Error on a unit that is unknown or belongs to another quantity.
[[nodiscard]] PlacedColumn place_column(const Header& header, Column column, std::size_t index,
                                        const std::optional<std::string>& unit);

// Whether the unit is one that the column may have.
[[nodiscard]] bool may_have_unit(Column column, const std::optional<std::string>& unit);

// Gives each uncertainty without a unit the unit of its quantity. Throws a bad-data Error when the axes have
// different units, or when the unit of an uncertainty cannot be converted to that of its quantity.
void settle_units(const Header& header, std::vector<PlacedColumn>& placed);

}  // namespace proofmass
