// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when the residuals of a mount lie to one side of zero, and of how many mounts. Mounts of fewer than
// three rows, and offsets that the terms take up, are not judged.
[[nodiscard]] std::optional<Finding> find_mount_offsets(const FittedRows& rows);

}  // namespace proofmass
