// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "proofmass/core/identification.hpp"

namespace proofmass {

// "13.062 ± 0.022 µg": in the unit that users speak, or in the output's own where that is no acceleration.
[[nodiscard]] std::string readable_text(const Coefficient& coefficient, const Unit& output);

// "[12.98, 13.14]", in the unit of readable_text; empty without an interval.
[[nodiscard]] std::string readable_interval(const Coefficient& coefficient, const Unit& output);

}  // namespace proofmass
