// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/identify/network/bp.hpp"
#include "proofmass/identify/network/pso_bp.hpp"

namespace proofmass {

// The paper's PSO-BP: 3-7-1 network, plain trainer, 50 particles over all 36 weights, inertia 0.6, both
// accelerations 1.5, global best, fitness by 20 epochs of training, 50 generations, then training of the best
// particle alone, with early stopping.
void apply_paper_preset(PsoBp& method);

// The paper's BP, its network and training alike.
void apply_paper_preset(Bp& method);

}  // namespace proofmass
