// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/reproduction.hpp"

#include <cmath>

namespace proofmass {

double SwarmGain::ratio() const {
  double sum = 0.0;
  for (std::size_t k = 0; k < bp_mse.size(); ++k) sum += std::log(bp_mse[k] / swarm_mse[k]);
  return std::exp(sum / static_cast<double>(bp_mse.size()));
}

}  // namespace proofmass
