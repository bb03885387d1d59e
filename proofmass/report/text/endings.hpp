// SPDX-License-Identifier: Apache-2.0
// The words of endings, in every language.
#pragma once

#include <span>
#include <string>

#include "proofmass/core/ending.hpp"
#include "proofmass/report/text/language.hpp"

namespace proofmass {

// Figures by name in braces; {parts} are the words of the parts within, one after the other, and {list} the
// same as a list.
[[nodiscard]] Words ending_words(EndingCode code) noexcept;

// One sentence: "swarm: all 60 iterations spent; training: the epochs allowed are spent".
[[nodiscard]] std::string sentence(std::span<const EndingPart> parts, Language language);

}  // namespace proofmass
