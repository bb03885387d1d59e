// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// Something that the residuals follow.
struct ResidualEffect {
  Finding finding;
  double errors = 0.0;  // of the strongest, standard errors from zero
  Matrix columns{};     // orthonormal, beyond the terms, that it is made of; empty where they are too many
};

using FindEffect = std::optional<ResidualEffect> (*)(const FittedRows& rows);

// What is found, without what another of them explains: mounts in sequence make a trend, a trend makes mounts
// differ. Of two that explain each other the one stays that is more standard errors from zero.
[[nodiscard]] std::vector<ResidualEffect> find_effects(const FittedRows& rows,
                                                       std::span<const FindEffect> sought);

// The rows as if the effects had been fitted too.
[[nodiscard]] FittedRows without_effects(const FittedRows& rows, std::span<const ResidualEffect> effects);

}  // namespace proofmass
