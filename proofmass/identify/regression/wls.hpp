// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/model/options.hpp"

namespace proofmass {

// Weighted least squares on the terms asked for (docs/wls.md). Weights are 1 / sigma_E² when the record has
// that column, otherwise those of the model sigma² = s0² + s1² |A|² fitted to the residuals by restricted
// maximum likelihood; the notes say which, with the figures. Throws as Method::identify says, and bad data
// when sigma_E is asked for and missing, or is not above zero in every row.
[[nodiscard]] Identification identify_wls(const Dataset& training, const Dataset& validation,
                                          const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
