// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

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

// The same for values in the declared unit, which its factor is then from; the unit as declared where there
// is no largest.
[[nodiscard]] ShownUnit shown_from_declared(const Unit& output, double largest);

// The values times a factor.
[[nodiscard]] std::vector<double> scaled(const std::vector<double>& values, double factor);

// The largest that is finite, of either sign.
[[nodiscard]] double largest_of(const std::vector<double>& values);

}  // namespace proofmass
