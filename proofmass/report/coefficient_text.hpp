// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "proofmass/core/identification.hpp"

namespace proofmass {

// "13.062 ± 0.022 µg": in the unit that users speak, or in the output's own where that is no acceleration.
[[nodiscard]] std::string readable_text(const Coefficient& coefficient, const Unit& output);

// The unit of readable_text, and its number alone: "13.062 ± 0.022"; of Ki, what Ki - 1 is.
[[nodiscard]] std::string reading_unit(Term term, const Unit& output);
[[nodiscard]] std::string readable_number(const Coefficient& coefficient, const Unit& output);

// "[12.98, 13.14]", in the unit of readable_text; empty without an interval.
[[nodiscard]] std::string readable_interval(const Coefficient& coefficient, const Unit& output);

}  // namespace proofmass
