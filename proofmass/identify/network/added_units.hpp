// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "proofmass/core/progress.hpp"
#include "proofmass/numeric/network/perceptron.hpp"
#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// Starts for a network of one hidden unit more: the hidden weights of the network, and a unit that a particle
// swarm found to lower the error over the samples most while the network's units stand still and the output
// layer is solved. The most promising first. Throws an Error of kind interrupted when the progress is
// cancelled.
[[nodiscard]] std::vector<std::vector<double>> starts_with_added_unit(const PerceptronShape& shape,
                                                                      std::span<const double> weights,
                                                                      const Samples& samples,
                                                                      std::uint64_t seed,
                                                                      const Progress& progress);

}  // namespace proofmass
