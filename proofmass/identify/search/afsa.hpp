// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/model/options.hpp"

namespace proofmass {

// An artificial fish swarm over the coefficients of the static model, for the least root mean square residual
// (docs/afsa.md). It has no use for validation rows. What it seeks is the least-squares solution, which is
// computed beside it: the result says how far from it the search stays, and the covariance is least squares'
// with that distance added, s² (XᵀX)⁻¹ + d dᵀ. Errors as Method::identify says.
[[nodiscard]] Identification identify_afsa(const Dataset& training, const Dataset& validation,
                                           const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
