// SPDX-License-Identifier: Apache-2.0
// The words of results in Chinese.
#pragma once

#include <string>

#include "proofmass/core/finding.hpp"

namespace proofmass {

// As english and english_reason.
[[nodiscard]] std::string chinese(const Finding& finding);
[[nodiscard]] std::string chinese_reason(const Finding& finding);

}  // namespace proofmass
