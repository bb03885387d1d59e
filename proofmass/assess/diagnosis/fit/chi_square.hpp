// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when the residuals are larger or smaller than the record's sigma_E (with the inputs' uncertainties
// where it has them) leads to expect, by chi² per degree of freedom, and how much of the residuals the
// uncertainties of the inputs explain where the method does not go by their columns. Where nothing else
// explains the residuals, and not of robust: when rows with large sigma_E and rows with small ones scatter by
// different multiples of it.
[[nodiscard]] std::vector<Finding> find_wrong_sigmas(const FittedRows& rows, const Identification& result,
                                                     bool input_columns_used, bool explained);

// That alone, of rows that nothing is suspected of: as if these had been fitted.
[[nodiscard]] std::optional<Finding> find_uneven_sigma(const FittedRows& rows, const Identification& result);

}  // namespace proofmass
