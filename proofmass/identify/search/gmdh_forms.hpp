// SPDX-License-Identifier: Apache-2.0
// The two forms of the group method of data handling, for gmdh.cpp to choose from.
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/search/gmdh.hpp"

namespace proofmass {

// Combinatorial: the terms with the least external criterion, refitted on all rows.
[[nodiscard]] Identification identify_gmdh_combi(const Gmdh& method, const Dataset& training,
                                                 const IdentifyOptions& options, Progress& progress);

// Multilayer iterative: a network of quadratic neurons, expanded into the terms.
[[nodiscard]] Identification identify_gmdh_mia(const Gmdh& method, const Dataset& training,
                                               const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
