// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/model/options.hpp"

namespace proofmass {

// Mixed least squares and total least squares (docs/tls.md): regressors without uncertainty are exact, the
// others are scaled by their first-order uncertainty, root mean square over the rows. Kept as a reference: it
// is the wrong model for products and powers, and says so. It has no use for validation rows. Errors as
// Method::identify says, and a refusal without uncertainties or without a generic solution.
[[nodiscard]] Identification identify_tls(const Dataset& training, const Dataset& validation,
                                          const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
