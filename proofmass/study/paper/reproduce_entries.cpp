// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/paper/reproduce_entries.hpp"

#include <string_view>
#include <utility>

#include "proofmass/pipeline.hpp"

namespace proofmass {
namespace {

Entry entry(std::string name, std::string_view method, std::string_view terms,
            const ReproduceOptions& budget) {
  Entry made{.name = std::move(name), .method = &find_method(method), .options = {}, .split = {}};
  made.options.terms = parse_terms(terms);
  made.options.seed = budget.seed;
  made.options.network.epochs = budget.refined_epochs;
  return made;
}

}  // namespace

Entry textbook_bp(const ReproduceOptions& budget) {
  Entry made = entry("BP", "bp", "paper", budget);
  made.options.network.trainer = Trainer::lm;
  made.options.network.epochs = budget.epochs;
  return made;
}

Entry paper_swarm(const ReproduceOptions& budget) {
  Entry made = entry("PSO-BP, paper", "pso-bp", "paper", budget);
  apply_paper_preset(made.options, made.split);
  made.options.network.epochs = budget.epochs;
  made.options.swarm.particles = budget.particles;
  made.options.swarm.iterations = budget.generations;
  made.options.swarm.fitness_epochs = budget.fitness_epochs;
  return made;
}

Entry multistart(const ReproduceOptions& budget) {
  Entry made = paper_swarm(budget);
  made.name = "multistart BP";
  made.method = &find_method("bp");
  made.options.network.starts = budget.particles * (budget.generations + 1);
  made.options.network.start_epochs = budget.fitness_epochs;
  return made;
}

Entry our_swarm(const ReproduceOptions& budget) { return entry("PSO-BP, ours", "pso-bp", "full", budget); }

std::vector<Entry> table_2_entries(const ReproduceOptions& budget) {
  return {entry("LSM, 8 terms", "ols", "K0,Ki,Kii,Kio,Kip,Kop,Ko,Kp", budget),
          entry("GMDH", "gmdh", "full", budget),
          paper_swarm(budget),
          our_swarm(budget),
          entry("LSM, 15 terms", "ols", "paper", budget),
          entry("LSM, 21 terms", "ols", "full", budget),
          entry("hybrid", "hybrid", "full", budget)};
}

}  // namespace proofmass
