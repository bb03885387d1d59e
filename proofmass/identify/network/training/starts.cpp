// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/training/starts.hpp"

#include "proofmass/numeric/random.hpp"

namespace proofmass {
std::vector<double> random_start(const PerceptronShape& shape, Trainer trainer, std::uint64_t seed,
                                 std::size_t index) {
  RandomStream random(seed, stream_id("start", index));
  std::vector<double> weights = nguyen_widrow(shape, random);
  if (trainer == Trainer::varpro) return weights;
  const std::vector<double> output = random_output_layer(shape, random);
  weights.insert(weights.end(), output.begin(), output.end());
  return weights;
}

}  // namespace proofmass
