// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <tuple>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/options/field.hpp"
#include "proofmass/identify/options/identify_options.hpp"
#include "proofmass/identify/options/method_info.hpp"
#include "proofmass/identify/regression/uncertainty_options.hpp"

namespace proofmass {

// Errors in variables: the true accelerations are unknowns, found together with the coefficients by weighted
// orthogonal distance regression (docs/eiv.md). Covariance with the true accelerations eliminated, as
// ODRPACK's, scaled or not as the options say. The history is the weighted sum of squares.
struct Eiv {
  UncertaintyOptions uncertainty{};
  std::size_t iterations = 200;  // at most

  // Those of the record that a fit goes by.
  [[nodiscard]] SigmaColumns sigma_columns() const noexcept;

  static constexpr MethodInfo info{
      .name = "eiv",
      .summary = "errors in variables: true accelerations found along with the coefficients",
      .page = "eiv.md",
      .training_fraction = 1.0};
  static constexpr auto fields = std::tuple{
      group(&Eiv::uncertainty, UncertaintyOptions::fields),
      field("eiv-iterations", &Eiv::iterations, "iterations, at most", whole(1), {.place = "eiv.md#how"})};
};

// Errors as fit in identify/method.hpp says, and a refusal without uncertainties or without convergence.
[[nodiscard]] Identification fit(const Eiv& method, const Dataset& training, const IdentifyOptions& options,
                                 Progress& progress);

}  // namespace proofmass
