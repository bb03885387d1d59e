// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "proofmass/study/comparison.hpp"

namespace proofmass {

// A comparison as JSON, schema "proofmass.comparison/1": every run's coefficients and metrics.
[[nodiscard]] std::string to_json(const Comparison& comparison);

}  // namespace proofmass
