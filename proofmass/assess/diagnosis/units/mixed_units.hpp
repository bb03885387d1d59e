// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "proofmass/core/dataset.hpp"

namespace proofmass {

// The fewer of the rows along the input axis whose ratio of output to input is a unit's ratio (g to m/s², or
// a prefix) times that of the others, where they follow the inputs much more closely when it is taken off;
// empty where the record has none.
[[nodiscard]] std::vector<std::size_t> rows_in_other_unit(const Dataset& record);

}  // namespace proofmass
