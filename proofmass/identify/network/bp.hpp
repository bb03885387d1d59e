// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/model/options.hpp"

namespace proofmass {

// BP: an ni-H-1 tanh network trained from Nguyen-Widrow starts. With one start this is the textbook method;
// with several, each is trained for start_epochs epochs and the most promising are trained to the end (the
// equal-budget rival of a swarm). Throws as prepare_network, and a refusal when no start trains.
[[nodiscard]] Identification identify_bp(const Dataset& training, const Dataset& validation,
                                         const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
