// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/paper/reproduce_entries.hpp"

#include <utility>

#include "proofmass/identify/network/presets.hpp"

namespace proofmass {
namespace {

Entry entry(std::string name, Method method, TermList terms, const ReproduceOptions& budget) {
  IdentifyOptions options{.terms = std::move(terms), .seed = budget.seed};
  return {.name = std::move(name), .method = std::move(method), .options = std::move(options)};
}

Entry least_squares(std::string name, TermList terms, const ReproduceOptions& budget) {
  return entry(std::move(name), Ols{}, std::move(terms), budget);
}

}  // namespace

Entry textbook_bp(const ReproduceOptions& budget) {
  Bp bp;
  bp.network.training.trainer = Trainer::lm;
  bp.network.training.epochs = budget.epochs;
  return entry("BP", bp, paper_terms(), budget);
}

Entry paper_swarm(const ReproduceOptions& budget) {
  PsoBp swarm;
  apply_paper_preset(swarm);
  swarm.network.training.epochs = budget.epochs;
  swarm.particles = budget.particles;
  swarm.iterations = budget.generations;
  swarm.fitness_epochs = budget.fitness_epochs;
  return entry("PSO-BP, paper", swarm, paper_terms(), budget);
}

Entry multistart(const ReproduceOptions& budget) {
  Bp bp;
  apply_paper_preset(bp);
  bp.network.training.epochs = budget.epochs;
  bp.starts = budget.particles * (budget.generations + 1);
  bp.start_epochs = budget.fitness_epochs;
  return entry("multistart BP", bp, paper_terms(), budget);
}

Entry our_swarm(const ReproduceOptions& budget) {
  PsoBp swarm;
  swarm.network.training.epochs = budget.refined_epochs;
  return entry("PSO-BP, ours", swarm, full_terms(), budget);
}

std::vector<Entry> table_2_entries(const ReproduceOptions& budget) {
  return {least_squares("LSM, 8 terms", parse_terms("K0,Ki,Kii,Kio,Kip,Kop,Ko,Kp"), budget),
          entry("GMDH", Gmdh{}, full_terms(), budget),
          paper_swarm(budget),
          our_swarm(budget),
          least_squares("LSM, 15 terms", paper_terms(), budget),
          least_squares("LSM, 21 terms", full_terms(), budget),
          entry("hybrid", Hybrid{}, full_terms(), budget)};
}

}  // namespace proofmass
