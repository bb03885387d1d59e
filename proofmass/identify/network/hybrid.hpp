// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/model/options.hpp"

namespace proofmass {

// Static model and tanh units in one separable problem: E = sum of terms + sum_j v_j tanh(w_j . A + b_j),
// linear in all but the hidden weights, which a particle swarm seeks and variable projection refines. The
// number of hidden units, zero included, has the least Bayesian information criterion (Schwarz 1978). With
// none this is ordinary least squares. The terms asked for must include K0, else a usage Error; otherwise
// throws as require_identifiable.
[[nodiscard]] Identification identify_hybrid(const Dataset& training, const Dataset& validation,
                                             const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
