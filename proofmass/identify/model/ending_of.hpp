// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "proofmass/core/ending.hpp"
#include "proofmass/numeric/optimise/termination.hpp"

namespace proofmass {

// How an identification ended whose iteration ended so; numeric and core have no words in common but here.
[[nodiscard]] EndingStatus ending_status(Cause cause) noexcept;
[[nodiscard]] std::vector<EndingPart> ending_parts(const Termination& termination);
[[nodiscard]] Ending ending_of(const Termination& termination);

}  // namespace proofmass
