// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "proofmass/core/identification.hpp"

namespace proofmass {

// MAE, MSE, RMSE, MAPE and R² of predictions against measured outputs (Shi et al., Table 3), both times
// `scale`: the factor from the canonical unit to the one to report in. Sizes must agree and not be zero, else
// std::invalid_argument.
[[nodiscard]] Metrics score(std::span<const double> measured, std::span<const double> predicted,
                            double scale = 1.0);

}  // namespace proofmass
