// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"

namespace proofmass {

// Adds the curve "test_rmse" to the history of a network: the error on the test rows, which training never
// sees, of the network at each epoch, in the output's declared unit. As long as the curve "training_rmse".
// Nothing without test rows, or for a result whose way of training is not known.
void add_test_curve(Identification& result, const Dataset& test);

}  // namespace proofmass
