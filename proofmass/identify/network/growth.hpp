// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "proofmass/core/ending.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/network/result.hpp"
#include "proofmass/identify/network/training/options.hpp"
#include "proofmass/identify/network/training/refinement.hpp"

namespace proofmass {

// How far a network may grow.
struct GrowthPlan {
  std::size_t most_hidden = 0;
  TrainingOptions training{};
  std::uint64_t seed = 1;
};

// The hidden units that the network of a task may come to have: as many as it has where growth cannot serve,
// because nothing is to grow, least squares leaves no noise to compare with, validation rows decide when
// training ends, the trainer is not varpro, or the rows are too few for more weights.
[[nodiscard]] std::size_t hidden_limit(const NetworkTask& task, const GrowthPlan& plan);

// Adds hidden units one by one to a network whose training error stays above that of least squares, until it
// represents what least squares finds or has as many as it may; then trains it on the measured output. The
// task and the refinement become those of the new network if its residual over the degrees of freedom is
// less. Returns what came of it. Throws an Error of kind interrupted when the progress is cancelled.
[[nodiscard]] EndingPart grow(NetworkTask& task, Refinement& refinement, const GrowthPlan& plan,
                              Progress& progress);

}  // namespace proofmass
