// SPDX-License-Identifier: Apache-2.0
// The words of results in English.
#pragma once

#include <string>

#include "proofmass/core/finding.hpp"

namespace proofmass {

// One sentence or two: what was found, with its figures, what follows, and what to do. The code and the
// figures where the finding lacks a figure of its sentence. Figures that the sentence names and the finding
// lacks are shown as "?".
[[nodiscard]] std::string english(const Finding& finding);

}  // namespace proofmass
