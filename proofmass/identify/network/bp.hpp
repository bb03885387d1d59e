// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <tuple>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/network/network_options.hpp"
#include "proofmass/identify/options/field.hpp"
#include "proofmass/identify/options/identify_options.hpp"
#include "proofmass/identify/options/method_info.hpp"

namespace proofmass {

// BP: an ni-H-1 tanh network trained from Nguyen-Widrow starts (docs/bp.md). With one start this is the
// textbook method; with several, each is trained for start_epochs epochs and the most promising are trained
// to the end (the equal-budget rival of a swarm).
struct Bp {
  NetworkOptions network{};
  std::size_t starts = 1;         // random starts; the best few are trained to the end
  std::size_t start_epochs = 20;  // epochs each start is given before the best are chosen
  std::size_t refined = 48;       // starts trained to the end at most; the best result is kept

  static constexpr MethodInfo info{
      .name = "bp",
      .summary = "a tanh network trained by back-propagation (Levenberg-Marquardt)",
      .page = "bp.md",
      .predicts_by_network = true,
      .exact_without_noise = false};
  static constexpr auto fields = std::tuple{
      group(&Bp::network, NetworkOptions::fields),
      field("starts", &Bp::starts, "random starts; the best few are trained to the end",
            whole(1, kMostMembers), {.place = "bp.md#training"}),
      field("start-epochs", &Bp::start_epochs, "epochs each of several starts gets before the choice",
            whole(1), {.place = "bp.md#training"}),
      field("refine", &Bp::refined, "candidates handed to the trainer at most; the best result is kept",
            whole(1, kMostMembers), {.place = "bp.md#training"})};
};

// Training stops early on the validation rows when there are any. Errors as fit in identify/method.hpp says,
// and a refusal when no start trains.
[[nodiscard]] Identification fit(const Bp& method, const Dataset& training, const Dataset& validation,
                                 const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
