// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/model/options.hpp"

namespace proofmass {

// M-estimation on the terms asked for (docs/robust.md): rows far from the rest lose weight, by the loss of
// Huber, of Tukey (bisquare) or of Student's t. The diagnostics list the suspect rows, largest residual
// first. Throws as Method::identify says; a refusal too when the rows that keep weight do not identify the
// terms, or the residuals are such that standard errors mean nothing.
[[nodiscard]] Identification identify_robust(const Dataset& training, const Dataset& validation,
                                             const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
