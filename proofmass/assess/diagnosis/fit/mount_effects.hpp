// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// Residuals that differ from mount to mount, by an offset or in proportion to Ai.
struct MountEffect {
  Finding finding;
  double errors = 0.0;  // of the strongest, standard errors from zero
  double probability = 1.0;
  Matrix columns;  // orthonormal, beyond the terms, one a mount: empty where they are too many
};

// The more significant of offsets and scale factors that mounts have of their own, and in how many mounts
// they show. Mounts of fewer than three rows, and effects that the terms take up, are not judged.
[[nodiscard]] std::optional<MountEffect> find_mount_effect(const FittedRows& rows);

}  // namespace proofmass
