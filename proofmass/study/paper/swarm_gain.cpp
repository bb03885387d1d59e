// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/paper/swarm_gain.hpp"

#include "proofmass/pipeline.hpp"
#include "proofmass/study/paper/reproduce_entries.hpp"

namespace proofmass {

SwarmGain measure_gain(SimulationPlan plan, double sigma, const Entry& swarm, const ReproduceOptions& budget,
                       StepProgress& steps) {
  plan.noise.sigma = sigma;
  SwarmGain gain{.sigma = sigma, .preset = swarm.name, .bp_mse = {}, .swarm_mse = {}};
  const auto count = static_cast<double>(budget.gain_seeds);
  const auto score = [&](Entry who, const Dataset& record, std::uint64_t seed, double& iterations) {
    who.options.seed = seed;
    const Identification result = identify(record, who.method, who.options, steps).identification;
    iterations += static_cast<double>(result.diagnostics.iterations.value_or(0)) / count;
    return result.test->mse;
  };
  for (std::size_t k = 0; k < budget.gain_seeds; ++k) {
    const std::uint64_t seed = budget.seed + k;
    const Dataset record = simulate(plan, plan.rows, seed);
    gain.bp_mse.push_back(score(textbook_bp(budget), record, seed, gain.bp_iterations));
    gain.swarm_mse.push_back(score(swarm, record, seed, gain.swarm_iterations));
    steps.step();
  }
  return gain;
}

}  // namespace proofmass
