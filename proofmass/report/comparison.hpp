// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "proofmass/assess/comparison.hpp"
#include "proofmass/report/terminal.hpp"

namespace proofmass {

// Coefficients side by side with their standard errors (first repeat), errors on train and test rows with
// their spread over the repeats, iterations and time with their ratios to the first method, and distances
// from the truth where it is known.
[[nodiscard]] std::string render_comparison(const Comparison& comparison, const TerminalStyle& style = {});

// The same, schema "proofmass.comparison/1": every run's coefficients and metrics.
[[nodiscard]] std::string to_json(const Comparison& comparison);

}  // namespace proofmass
