// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/static_model.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/network/network_options.hpp"
#include "proofmass/identify/network/training/refinement.hpp"
#include "proofmass/identify/options/identify_options.hpp"

namespace proofmass {

// What every network method starts from.
struct NetworkTask {
  Identifiability found;
  Dataset training;        // in canonical order
  TrainedNetwork network;  // scaling learned, weights not yet
  PerceptronShape shape;
  Samples samples;
  std::optional<Samples> validation;
  // Training error (scaled output) of least squares with every term that the rows can tell apart.
  double least_squares_rmse = 0.0;
  double least_squares_sd = 0.0;  // the same over the degrees of freedom; zero when there are none
  StaticModel least_squares;      // its terms and coefficients
  // Whether that is more than rounding.
  [[nodiscard]] bool leaves_noise() const noexcept;
  // Training error at which more starts are not worth their time.
  [[nodiscard]] double good_enough() const noexcept { return 1.01 * least_squares_rmse; }
};

// Checks that the record can serve: identifiable terms by the policy of the options, more rows than weights.
// Throws as require_identifiable, and bad data naming how many rows the network needs.
[[nodiscard]] NetworkTask prepare_network(const NetworkOptions& network, const Dataset& training,
                                          const Dataset& validation, const IdentifyOptions& options);

// The Identification of a trained network: coefficients extracted as the options say, diagnostics, training
// curves and ending.
[[nodiscard]] Identification make_network_identification(std::string_view method, const NetworkTask& task,
                                                         Extraction extraction,
                                                         const IdentifyOptions& options,
                                                         const Refinement& refinement);

}  // namespace proofmass
