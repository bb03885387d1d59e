// SPDX-License-Identifier: Apache-2.0
// Records without a fault, for the programs that count over sensors drawn at random.
#pragma once

#include <cmath>

#include "proofmass/core/dataset.hpp"
#include "proofmass/numeric/random.hpp"
#include "proofmass/stand/twin/simulation.hpp"

namespace proofmass {

inline constexpr double kUg = 1e-6;  // g

// Random directions, 1 to 20 g.
[[nodiscard]] inline SimulationPlan sphere(double sigma) {
  SimulationPlan plan;
  plan.sphere = SphereInputs{};
  plan.noise.sigma = sigma;
  return plan;
}

// Noise between 1 and 100 ug, different from row to row, and known.
inline void add_uneven_noise(Dataset& record, RandomStream& random) {
  record.output_sigma.clear();
  for (double& e : record.output) {
    const double sigma = kUg * std::pow(100.0, random.uniform());
    record.output_sigma.push_back(sigma);
    e += sigma * random.normal();
  }
}

}  // namespace proofmass
