// SPDX-License-Identifier: Apache-2.0
// The least standard errors that unbiased estimates from a record can have (Cramér-Rao).
#pragma once

#include <span>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/term.hpp"

namespace proofmass {

// Density of noise of scale 1: normal or Student, with a fraction of outliers at plus and minus `distance`
// scales, half of them on each side.
struct LocationDensity {
  double dof = 0.0;  // of Student's t; 0: normal
  double fraction = 0.0;
  double distance = 0.0;
};

// Fisher information about the location of that noise, the integral of f'²/f: 1 for the normal, (dof + 1) /
// (dof + 3) for Student's t, with outliers by the midpoint rule far beyond them.
[[nodiscard]] double location_information(const LocationDensity& noise);

// Standard errors from the inverse of XᵀWX, a term each, in the output's canonical unit per g^order. W holds
// the information about the location of each row's output, one over the unit squared: one over the variance
// for normal noise. Throws std::invalid_argument when the rows cannot tell the terms apart.
[[nodiscard]] std::vector<double> efficient_errors(const Dataset& rows, const TermList& terms,
                                                   std::span<const double> information);

}  // namespace proofmass
