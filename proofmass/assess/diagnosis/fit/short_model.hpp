// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when the residuals follow terms of the static model that were not asked for and that the rows can
// tell apart from those that were. Not of methods that choose their terms, or that fit what terms lack.
[[nodiscard]] std::optional<Finding> find_short_model(const FittedRows& rows, const Identification& result);

}  // namespace proofmass
