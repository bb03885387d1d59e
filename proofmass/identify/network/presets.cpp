// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/presets.hpp"

namespace proofmass {
namespace {

void apply_paper_preset(NetworkOptions& network) {
  network.hidden = 7;
  network.training.trainer = Trainer::lm;
  network.training.epochs = 1000;
  network.early_stopping = true;
}

}  // namespace

void apply_paper_preset(PsoBp& method) {
  apply_paper_preset(method.network);
  method.grow_to = 0;
  method.particles = 50;
  method.iterations = 50;
  method.inertia = 0.6;
  method.cognitive = 1.5;
  method.social = 1.5;
  method.topology = SwarmTopology::global;
  // The paper says neither. Synchronous, so that evaluations run in parallel: with trained fitness the
  // swarm's own convergence hardly matters. The limit keeps tanh out of saturation.
  method.update = SwarmUpdate::synchronous;
  method.velocity_limit = 0.5;
  method.fitness = SwarmFitness::trained;
  method.fitness_epochs = 20;
  method.refined = 1;
}

void apply_paper_preset(Bp& method) {
  apply_paper_preset(method.network);
  method.refined = 1;
}

}  // namespace proofmass
