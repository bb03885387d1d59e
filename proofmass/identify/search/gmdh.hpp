// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/model/options.hpp"

namespace proofmass {

// Group method of data handling (Ivakhnenko 1970; docs/gmdh.md): the structure is chosen by an external
// criterion. Form combi chooses terms of the static model and refits them by least squares on all training
// rows; terms it leaves out come back as not identified, with their reason. Form mia grows a network of
// quadratic neurons and expands it into the terms. The result predicts by the coefficients in both forms. It
// has no use for validation rows. Errors as Method::identify says; a usage Error on options that make no
// sense.
[[nodiscard]] Identification identify_gmdh(const Dataset& training, const Dataset& validation,
                                           const IdentifyOptions& options, Progress& progress);

}  // namespace proofmass
