// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "proofmass/core/finding.hpp"

namespace proofmass {

// As english_diagnosis and english_diagnosis_phrase.
[[nodiscard]] std::string_view chinese_diagnosis(Code code) noexcept;
[[nodiscard]] std::string_view chinese_diagnosis_phrase(std::string_view figure,
                                                        std::string_view word) noexcept;

}  // namespace proofmass
