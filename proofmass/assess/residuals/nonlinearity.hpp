// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "proofmass/core/identification.hpp"

namespace proofmass {

// What the identified terms of Ai alone add to the straight line K0 + Ki Ai: Kii Ai² + Koq |Ai|Ai + Kiii Ai³,
// over the range of Ai, with the half width of its 95 % confidence interval at each place; in the output's
// canonical unit.
struct Nonlinearity {
  TermList terms;             // those of Ai alone
  std::vector<double> input;  // Ai, g
  std::vector<double> value;
  std::vector<double> half_width;  // empty where the covariance is not known
};

// Empty where no such term is identified, or the range of Ai is not known.
[[nodiscard]] Nonlinearity nonlinearity_of(const Identification& result);

}  // namespace proofmass
