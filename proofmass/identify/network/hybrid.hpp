// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <tuple>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/network/training/options.hpp"
#include "proofmass/identify/options/field.hpp"
#include "proofmass/identify/options/identify_options.hpp"
#include "proofmass/identify/options/method_info.hpp"

namespace proofmass {

// Static model and tanh units in one separable problem: E = sum of terms + sum_j v_j tanh(w_j . A + b_j),
// linear in all but the hidden weights, which a particle swarm seeks and variable projection refines
// (docs/hybrid.md). The number of hidden units, zero included, has the least Bayesian information criterion
// (Schwarz 1978). With none this is ordinary least squares. The terms asked for must include K0.
struct Hybrid {
  std::size_t most_hidden = 8;  // tanh units at most
  std::size_t patience = 2;     // sizes without a better criterion that end the search
  std::size_t particles = 30;   // of the swarm over the hidden weights
  std::size_t iterations = 20;
  std::size_t refined = 8;   // best particles trained to the end
  std::size_t epochs = 300;  // of the training of a candidate by variable projection, at most
  std::size_t perturbations = TrainingOptions{}.perturbations;

  static constexpr MethodInfo info{
      .name = "hybrid",
      .summary =
          "static model and network together, hidden units chosen by the Bayesian information criterion",
      .page = "hybrid.md"};
  static constexpr auto fields = std::tuple{
      field("most-hidden", &Hybrid::most_hidden, "hidden units tried, at most", whole(0, kMostUnits),
            {.place = "hybrid.md#how-many-hidden-units"}),
      field("patience", &Hybrid::patience,
            "the search ends after N sizes in a row without a smaller criterion", whole(1, kMostUnits),
            {.place = "hybrid.md#how-many-hidden-units"}),
      field("particles", &Hybrid::particles, "particles of the swarm", whole(1, kMostMembers),
            {.place = "hybrid.md#how-many-hidden-units"}),
      field("iterations", &Hybrid::iterations, "iterations of the swarm, at most; 0: particles as they start",
            whole(0), {.place = "hybrid.md#how-many-hidden-units"}),
      field("refine", &Hybrid::refined, "candidates handed to the trainer at most; the best result is kept",
            whole(1, kMostMembers), {.place = "hybrid.md#how-many-hidden-units"}),
      epochs_field(&Hybrid::epochs),
      perturbations_field(&Hybrid::perturbations)};
};

// A usage Error without K0; otherwise errors as fit in identify/method.hpp says.
[[nodiscard]] Identification fit(const Hybrid& method, const Dataset& training,
                                 const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
