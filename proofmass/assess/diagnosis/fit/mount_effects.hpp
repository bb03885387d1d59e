// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/assess/diagnosis/fit/residual_effect.hpp"

namespace proofmass {

// Residuals that differ from mount to mount: the most significant of offsets, scale factors and alignments
// (in proportion to Ao or Ap) that mounts have of their own, and in how many mounts it shows. Mounts of fewer
// than three rows, and effects that the terms take up, are not judged.
[[nodiscard]] std::optional<ResidualEffect> find_mount_effect(const FittedRows& rows);

}  // namespace proofmass
