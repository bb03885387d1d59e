// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/options/field.hpp"
#include "proofmass/identify/options/identify_options.hpp"
#include "proofmass/identify/options/method_info.hpp"
#include "proofmass/identify/regression/uncertainty_options.hpp"

namespace proofmass {

// Mixed least squares and total least squares (docs/tls.md): regressors without uncertainty are exact, the
// others are scaled by their first-order uncertainty, root mean square over the rows. Kept as a reference: it
// is the wrong model for products and powers, and says so.
struct Tls {
  UncertaintyOptions uncertainty{};

  // Those of the record that a fit goes by.
  [[nodiscard]] SigmaColumns sigma_columns() const noexcept;

  static constexpr MethodInfo info{
      .name = "tls",
      .summary = "mixed least squares and total least squares; a reference, biased for powers",
      .page = "tls.md",
      .training_fraction = 1.0};
  static constexpr auto fields = std::tuple{group(&Tls::uncertainty, UncertaintyOptions::fields)};
};

// Errors as fit in identify/method.hpp says, and a refusal without uncertainties or without a generic
// solution.
[[nodiscard]] Identification fit(const Tls& method, const Dataset& training, const IdentifyOptions& options,
                                 Progress& progress);

}  // namespace proofmass
