// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "proofmass/core/progress.hpp"
#include "proofmass/identify/network/training/trainer.hpp"

namespace proofmass {

// Candidates trained together: no further ones are tried when one of them is good enough.
inline constexpr std::size_t kRefinementBatch = 16;

// How much training to spend.
struct RefinementPlan {
  std::size_t epochs = 1000;  // at most, for one candidate
  double good_enough = 0.0;   // training error (scaled output) at which no further batch is tried
  std::string_view stage = "training";
};

// What training several networks and keeping the best came to.
struct Refinement {
  TrainingState best;
  std::size_t epochs = 0;      // of all candidates together, from their start
  std::size_t candidates = 0;  // trained
};

// Trains the candidates, the most promising first, in batches until one is good enough. Within a batch all
// are trained a little, the better half of them twice as long, and so on; the last two are given up to
// `epochs` epochs each: a wrong start costs little, and a right one is not lost to a slow beginning. What is
// left of its epochs polishes the best of a batch.
// Candidates run in parallel. Throws an Error of kind interrupted when the progress is cancelled.
[[nodiscard]] Refinement refine(const NetworkTrainer& trainer, std::vector<TrainingState> candidates,
                                const RefinementPlan& plan, Progress& progress);

}  // namespace proofmass
