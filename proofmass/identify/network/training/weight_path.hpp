// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "proofmass/core/identification.hpp"

namespace proofmass {

// Adds the weights of an epoch to a path, in one part or two, unless the training error, of the scaled
// output, is less than a thousandth below that of the last one: what is left out would not show in a curve.
void add_to_path(TrainingPath& path, std::size_t epoch, double training_rmse, std::span<const double> weights,
                 std::span<const double> further_weights = {});

}  // namespace proofmass
