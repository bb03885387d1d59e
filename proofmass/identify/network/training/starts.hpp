// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "proofmass/identify/network/training/options.hpp"
#include "proofmass/numeric/network/perceptron.hpp"

namespace proofmass {

// Initial weights number `index` of a seed, by Nguyen and Widrow: hidden weights alone for the varpro
// trainer, which solves the output layer, all weights for lm.
[[nodiscard]] std::vector<double> random_start(const PerceptronShape& shape, Trainer trainer,
                                               std::uint64_t seed, std::size_t index);

}  // namespace proofmass
