// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "proofmass/core/finding.hpp"

namespace proofmass {

// The sentences, in English, on faults of records and fits, and the phrases for the choices that they
// name; empty for other codes and figures. Figures are in braces.
[[nodiscard]] std::string_view english_diagnosis(Code code) noexcept;
[[nodiscard]] std::string_view english_diagnosis_phrase(std::string_view figure,
                                                        std::string_view word) noexcept;

}  // namespace proofmass
