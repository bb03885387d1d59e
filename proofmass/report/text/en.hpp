// SPDX-License-Identifier: Apache-2.0
// The words of results in English.
#pragma once

#include <string>

#include "proofmass/core/finding.hpp"

namespace proofmass {

// One sentence or two: what was found, with its figures, what follows, and what to do. The code and the
// figures where the finding lacks a figure of its sentence.
[[nodiscard]] std::string english(const Finding& finding);

// The reason alone, of a finding that says why a term is not identified: "aliased with Kii: over these rows
// |Ai|*Ai is proportional to Ai^2".
[[nodiscard]] std::string english_reason(const Finding& finding);

}  // namespace proofmass
