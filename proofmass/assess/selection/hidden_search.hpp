// SPDX-License-Identifier: Apache-2.0
// The choice of the number of hidden units by trial.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/core/run.hpp"
#include "proofmass/identify/method.hpp"

namespace proofmass {

// Sizes of the rule sqrt(inputs + outputs) + alpha, alpha = 1 ... 10, the root rounded (Shi et al.),
// ascending.
[[nodiscard]] std::vector<std::size_t> hidden_sizes(std::size_t inputs);

// Index of the smallest size whose mean error is within one standard error (of the mean over repeats) of the
// least mean (Breiman et al. 1984, section 3.4.3). Trials ascend in size and have the same number of repeats.
[[nodiscard]] std::size_t choose_hidden(std::span<const HiddenTrial> trials);

// Trains every size once on each of the splits, number r of them from the starts of the seed plus r, the same
// for all sizes, and scores it on the rows that the split sets aside (its validation part), which also end
// the training where it stops early. Sizes with more weights than rows are left out. Throws a
// usage Error on a method without such a network or fewer than two splits, what the method throws, and its
// refusal of too few rows when no size is left.
[[nodiscard]] std::vector<HiddenTrial> try_hidden_sizes(const Dataset& rows, const Method& method,
                                                        const IdentifyOptions& options,
                                                        std::span<const Split> splits, Progress& progress);

}  // namespace proofmass
