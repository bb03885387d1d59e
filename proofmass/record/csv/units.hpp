// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "proofmass/record/csv/layout.hpp"

namespace proofmass {

// A column of the file taken as a column of the contract, in the unit written or else in the contract's
// default: g, degC, s; for an uncertainty the unit of its quantity, which settle_units() supplies. Throws a
// bad-data Error on a unit that is unknown or of another quantity.
[[nodiscard]] PlacedColumn place_column(const Header& header, Column column, std::size_t index,
                                        const std::optional<std::string>& unit);

// Gives uncertainties without a unit that of their quantity. Throws a bad-data Error when the axes differ in
// unit, or an uncertainty cannot be converted to its quantity's unit.
void settle_units(const Header& header, std::vector<PlacedColumn>& placed);

}  // namespace proofmass
