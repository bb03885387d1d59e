// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "proofmass/core/progress.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "proofmass/study/paper/reproduction.hpp"

namespace proofmass {

// How far to go. The defaults are the full run; the paper's budgets are 1000 epochs, and 50 particles of 50
// generations of 20 epochs.
struct ReproduceOptions {
  std::uint64_t seed = 1;             // of record, split and draws; repeats count up from it
  std::size_t size_repeats = 5;       // trainings of each hidden size; Table 1
  std::size_t repeats = 5;            // splits and starts of Table 3
  std::size_t gain_seeds = 10;        // records of each noise for BP against PSO-BP
  std::size_t epochs = 1000;          // of textbook BP, and of the paper's final training
  std::size_t particles = 50;         // of the paper's swarm
  std::size_t generations = 50;       // of the paper's swarm
  std::size_t fitness_epochs = 20;    // of the paper's swarm, an evaluation
  std::size_t refined_epochs = 1000;  // of our own PSO-BP, each particle, at most
};

// The same with one repeat, and two records of each noise: under a minute on two cores.
[[nodiscard]] ReproduceOptions quick_reproduction();

// Repeats the paper's experiment on records of the plan, outputs in m/s². Throws an Error of kind interrupted
// when the progress is cancelled, and what a method throws.
[[nodiscard]] Reproduction reproduce(SimulationPlan twin, const ReproduceOptions& options,
                                     Progress& progress);

}  // namespace proofmass
