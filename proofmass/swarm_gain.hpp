// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/assess/reproduction.hpp"
#include "proofmass/compare.hpp"
#include "proofmass/core/step_progress.hpp"
#include "proofmass/reproduce.hpp"
#include "proofmass/stand/simulation.hpp"

namespace proofmass {

// Textbook BP against a PSO-BP on records of the plan with noise of `sigma` g, `gain_seeds` of them: record,
// split and draws by the seed of the budget and those after it. One step of the progress a record.
[[nodiscard]] SwarmGain measure_gain(SimulationPlan plan, double sigma, const Entry& swarm,
                                     const ReproduceOptions& budget, StepProgress& steps);

}  // namespace proofmass
