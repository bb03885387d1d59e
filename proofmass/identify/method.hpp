// SPDX-License-Identifier: Apache-2.0
// The one interface of every method of identification, and the list of those there are.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/model/options.hpp"
#include "proofmass/identify/regression/uncertainties.hpp"

namespace proofmass {

struct Method {
  std::string_view name;     // as --method takes it
  std::string_view summary;  // one line, for --help
  bool predicts_by_network;  // the fit predicts by its network, not by the coefficients
  bool takes_hidden;         // its network has the number of hidden units that the options say
  bool exact_without_noise;  // recovers the coefficients of a noise-free record to rounding
  // Fits the training rows; network methods stop early on the validation rows when there are any. Fills
  // method, coefficients with covariance and standard errors, network, ending, history and what of the
  // diagnostics is the method's own; intervals and metrics are assess's. Throws a refusal when the terms
  // cannot be identified or no usable fit came out, bad data when the record cannot serve the method.
  Identification (*identify)(const Dataset& training, const Dataset& validation,
                             const IdentifyOptions& options, Progress& progress);
  // The record's sigma columns that a fit with these options goes by; null for methods that go by none.
  SigmaColumns (*sigma_columns)(const IdentifyOptions& options) = nullptr;
};

[[nodiscard]] std::span<const Method> methods() noexcept;

// Throws a usage Error listing the names there are when `name` is not among them.
[[nodiscard]] const Method& find_method(std::string_view name);

// The output that an identification predicts for each row of inputs, in the output's canonical unit: by its
// network when it has one, otherwise by its static model. Throws bad data when the inputs lack an axis that
// the fit used.
[[nodiscard]] std::vector<double> predict(const Identification& fit, const Dataset& inputs);

}  // namespace proofmass
