// SPDX-License-Identifier: Apache-2.0
// What methods share once they have values for the coefficients of the static model.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/options/identify_options.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// Values for the identified terms, in canonical order. Units: the output's canonical unit per g^order.
struct StaticFit {
  std::vector<double> coefficients;
  Matrix covariance;        // of the coefficients; 0 x 0 when the method knows none
  std::vector<double> vif;  // one a coefficient, NaN where it has none; or empty
};

// The preset with exactly these terms, otherwise their names.
[[nodiscard]] std::string model_name(const TermList& terms);

// An Identification with method, model, seed, unit, one coefficient a term asked for (unidentifiable ones
// marked, with their reason), covariance, standard errors, condition numbers, and findings on unidentifiable
// and on badly determined terms. Residual figures, network, ending and history are left to the method. Throws
// std::invalid_argument when the sizes disagree.
[[nodiscard]] Identification make_identification(std::string_view method, const Dataset& training,
                                                 const IdentifyOptions& options, const Identifiability& found,
                                                 const StaticFit& fit);

// Fills residual_sd, dof and r2_adjusted from a fit's residuals over the training rows. Adjusted R² is
// 1 - (RSS / dof) / (TSS / (n - 1)), TSS about the mean. `parameters` counts what the fit was free to choose.
void add_residual_figures(Diagnostics& diagnostics, const Dataset& training, double rss,
                          std::size_t parameters);

// Says that the method weighs all rows alike where the record has a column sigma_E.
void note_unused_sigma(Identification& result, const Dataset& training);

}  // namespace proofmass
