// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "proofmass/core/units.hpp"

namespace proofmass {

// The unit to draw values of one size in: shown = canonical * factor.
struct ShownUnit {
  double factor = 1.0;
  std::string symbol;
};

// For values up to `largest` in the output's canonical unit: the declared unit with the SI prefix, or power
// of ten, that leaves numbers between 0.1 and 1000.
[[nodiscard]] ShownUnit shown_unit(const Unit& output, double largest);

}  // namespace proofmass
