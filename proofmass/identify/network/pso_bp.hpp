// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/model/options.hpp"

namespace proofmass {

// PSO-BP: a particle swarm seeks initial weights, the most promising and mutually different particles are
// trained, and the best network is kept. With apply_paper_preset this is the paper's method (Shi et al.,
// section 3); the defaults are ours: the swarm moves in the space of the hidden weights with the output layer
// solved inside, and the trainer is variable projection. Throws as prepare_network, and a refusal when no
// particle trains.
[[nodiscard]] Identification identify_pso_bp(const Dataset& training, const Dataset& validation,
                                             const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
