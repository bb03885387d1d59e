// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/presets.hpp"

namespace proofmass {

void apply_paper_preset(IdentifyOptions& options) {
  options.network.hidden = 7;
  options.network.trainer = Trainer::lm;
  options.network.epochs = 1000;
  SwarmOptions& swarm = options.swarm;
  swarm.particles = 50;
  swarm.iterations = 50;
  swarm.inertia = 0.6;
  swarm.cognitive = 1.5;
  swarm.social = 1.5;
  swarm.topology = SwarmTopology::global;
  // The paper says neither. Synchronous, so that evaluations run in parallel: with trained fitness the
  // swarm's own convergence hardly matters. The limit keeps tanh out of saturation.
  swarm.update = SwarmUpdate::synchronous;
  swarm.velocity_limit = 0.5;
  swarm.fitness = SwarmFitness::trained;
  swarm.fitness_epochs = 20;
  swarm.refined = 1;
}

}  // namespace proofmass
