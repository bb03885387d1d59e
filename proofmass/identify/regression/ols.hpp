// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/model/options.hpp"

namespace proofmass {

// Ordinary least squares on the terms asked for (docs/ols.md). It has no use for validation rows. Covariance
// s² (XᵀX)⁻¹ with s² = RSS / (n - terms): right when the output's noise is white and alike in every row and
// the inputs are exact. Errors as Method::identify says.
[[nodiscard]] Identification identify_ols(const Dataset& training, const Dataset& validation,
                                          const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
