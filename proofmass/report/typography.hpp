// SPDX-License-Identifier: Apache-2.0
// Numbers and units as they are printed (SI Brochure, 9th edition, 5.4).
#pragma once

#include <string>
#include <string_view>

namespace proofmass {

// "10⁻⁶".
[[nodiscard]] std::string power_of_ten(int exponent);

// Numbers as the program writes them, for print: "-1.5e-06 ± 2e-08" becomes "−1.5 × 10⁻⁶ ± 2 × 10⁻⁸".
[[nodiscard]] std::string typeset(std::string_view text);

// "g/g^2" becomes "g/g²", "m/s^2" "m/s²", "ug" "µg".
[[nodiscard]] std::string typeset_unit(std::string_view unit);

// The square of a unit as it is printed: "g²", "(m/s²)²".
[[nodiscard]] std::string squared_unit(std::string_view unit);

}  // namespace proofmass
