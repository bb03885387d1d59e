// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/model/options.hpp"

namespace proofmass {

// Errors in variables: the true accelerations are unknowns, found together with the coefficients by weighted
// orthogonal distance regression (docs/eiv.md). It has no use for validation rows. Covariance with the true
// accelerations eliminated, as ODRPACK's, scaled or not as the options say. The history is the weighted sum
// of squares. Errors as Method::identify says, and a refusal without uncertainties or without convergence.
[[nodiscard]] Identification identify_eiv(const Dataset& training, const Dataset& validation,
                                          const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
