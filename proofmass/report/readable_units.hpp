// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "proofmass/core/term.hpp"
#include "proofmass/core/units.hpp"

namespace proofmass {

// How a coefficient of an accelerometer is read aloud: shown = (value - offset) * factor, in `symbol`. A
// standard error is shown without the offset.
struct ReadableUnit {
  double offset = 0.0;
  double factor = 1.0;
  std::string symbol;
};

// The unit users read a coefficient in when it is referred to input (g per g^order): µg for the bias, ppm of
// Ki - 1, µrad for the misalignments Ko and Kp, µg/g² and µg/g³ for the rest.
[[nodiscard]] ReadableUnit readable_unit(Term term);

// The unit a coefficient is stored in: "g", "mA/g", "g/g^2".
[[nodiscard]] std::string coefficient_unit(Term term, const Unit& output);

// A value in the output's canonical unit, as the record declares the output.
[[nodiscard]] double to_declared(double canonical, const Unit& output) noexcept;

}  // namespace proofmass
