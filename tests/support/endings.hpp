// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "proofmass/core/ending.hpp"
#include "proofmass/report/text/endings.hpp"

namespace proofmass::test {

// The sentence of an ending, in English.
inline std::string said(const Ending& ending) { return sentence(ending.parts, Language::en); }

}  // namespace proofmass::test
