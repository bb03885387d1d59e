// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/ending.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/network/hybrid.hpp"

namespace proofmass {

// A static model and a network side by side, fitted to a record.
struct HybridFit {
  TrainedNetwork network;       // with the static part in its skip
  double rss = 0.0;             // over the training rows, canonical output unit squared
  std::size_t parameters = 0;   // free ones: terms and weights
  std::size_t epochs = 0;       // of training, all candidates together
  std::size_t evaluations = 0;  // of the swarm's fitness
  std::vector<double> curve;    // training rmse of the candidate kept, scaled output
  std::vector<double> swarm;    // best fitness of the swarm, likewise
  // How the training of the candidate kept ended.
  EndingStatus training = EndingStatus::iteration_limit;
};

// The best fit with `hidden` >= 1 tanh units beside the terms (K0 among them, played by the network's bias).
[[nodiscard]] HybridFit fit_hybrid(const Hybrid& method, const Dataset& training, const TermList& terms,
                                   std::size_t hidden, std::uint64_t seed, Progress& progress);

}  // namespace proofmass
