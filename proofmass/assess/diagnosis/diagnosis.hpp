// SPDX-License-Identifier: Apache-2.0
// What in a record or a fit cannot be what it claims (docs/diagnosis.md). Clean records give no warning.
#pragma once

#include <span>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/run.hpp"

namespace proofmass {

// Of the record alone: units, limits of the output, its counts, repeated rows, time.
[[nodiscard]] std::vector<Finding> diagnose_record(const Dataset& record);

// Of a fit to the record's training rows, scored: coefficients, residuals, uncertainties, test rows. The same
// for every method. `of_record`: what was found in the record, whose consequences are not named again.
// `inputs_sigma_used`: whether the method takes the uncertainties of the inputs into
// account.
[[nodiscard]] std::vector<Finding> diagnose_fit(const Dataset& record, std::span<const Finding> of_record,
                                                const Split& split, const Identification& result,
                                                bool inputs_sigma_used);

}  // namespace proofmass
