// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/paper/reproduction.hpp"

#include <cmath>

namespace proofmass {

double SwarmGain::ratio() const {
  double sum = 0.0;
  for (std::size_t k = 0; k < bp_mse.size(); ++k) sum += std::log(bp_mse[k] / swarm_mse[k]);
  return std::exp(sum / static_cast<double>(bp_mse.size()));
}

std::optional<double> implied_variance(const Contestant& contestant) {
  const std::optional<Metrics>& test = contestant.runs.front().identification.test;
  if (!test || !test->r2 || !(*test->r2 < 1.0)) return std::nullopt;
  return test->mse / (1.0 - *test->r2);
}

}  // namespace proofmass
