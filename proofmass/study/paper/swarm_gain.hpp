// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/step_progress.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "proofmass/study/compare.hpp"
#include "proofmass/study/paper/reproduce.hpp"
#include "proofmass/study/paper/reproduction.hpp"

namespace proofmass {

// Textbook BP against a PSO-BP on records of the plan with noise of `sigma` g, `gain_seeds` of them: record,
// split and draws by the seed of the budget and those after it. One step of the progress a record.
[[nodiscard]] SwarmGain measure_gain(SimulationPlan plan, double sigma, const Entry& swarm,
                                     const ReproduceOptions& budget, StepProgress& steps);

}  // namespace proofmass
