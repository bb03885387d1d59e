// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/core/run.hpp"

namespace proofmass {

// Says when the errors on the test rows are more than three times those that the noise and the uncertainty of
// the fit lead to expect: the training rows do not speak for them.
[[nodiscard]] std::optional<Finding> find_unlike_rows(const FittedRows& rows, const Dataset& record,
                                                      const Split& split, const Identification& result);

}  // namespace proofmass
