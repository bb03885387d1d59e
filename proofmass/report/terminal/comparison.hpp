// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "proofmass/report/terminal/terminal.hpp"
#include "proofmass/study/comparison.hpp"

namespace proofmass {

// Coefficients side by side with their standard errors (first repeat), errors on train and test rows with
// their spread over the repeats, iterations and time with their ratios to the first method, and distances
// from the truth where it is known.
[[nodiscard]] std::string render_comparison(const Comparison& comparison, const TerminalStyle& style = {});

}  // namespace proofmass
