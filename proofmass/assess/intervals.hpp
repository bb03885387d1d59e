// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/identification.hpp"

namespace proofmass {

// Adds t, p and the 95 % interval to every identified coefficient with a standard error, by Student's t with
// the diagnostics' degrees of freedom; by the normal distribution when a method states none. A standard error
// of zero gives an interval of no width, and neither t nor p.
void add_intervals(Identification& result);

// Half the width of a two-sided 95 % interval over the standard error: Student's t with the diagnostics'
// degrees of freedom, the normal distribution when a method states none or has none left.
[[nodiscard]] double coverage_factor(const Identification& result);

}  // namespace proofmass
