// SPDX-License-Identifier: Apache-2.0
// The words of findings, in every language.
#pragma once

#include <string>

#include "proofmass/core/finding.hpp"
#include "proofmass/report/text/language.hpp"

namespace proofmass {

// One sentence or two: what was found, with its figures, what follows, and what to do.
[[nodiscard]] std::string sentence(const Finding& finding, Language language);

// The reason alone, of a finding that says why a term is not identified.
[[nodiscard]] std::string reason(const Finding& finding, Language language);

}  // namespace proofmass
