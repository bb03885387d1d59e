// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/progress.hpp"
#include "proofmass/identify/options/field.hpp"
#include "proofmass/identify/options/identify_options.hpp"
#include "proofmass/identify/options/method_info.hpp"

namespace proofmass {

// Ordinary least squares on the terms asked for (docs/ols.md). Covariance s² (XᵀX)⁻¹ with s² = RSS / (n -
// terms): right when the output's noise is white and alike in every row and the inputs are exact.
struct Ols {
  static constexpr MethodInfo info{.name = "ols",
                                   .summary = "ordinary least squares on the terms of the static model",
                                   .page = "ols.md",
                                   .training_fraction = 1.0};
  static constexpr std::tuple<> fields{};
};

// Errors as fit in identify/method.hpp says.
[[nodiscard]] Identification fit(const Ols& method, const Dataset& training, const IdentifyOptions& options,
                                 Progress& progress);

}  // namespace proofmass
