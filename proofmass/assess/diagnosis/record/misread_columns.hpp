// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when a column is something else than its name says: the outputs are a copy of an input, or would
// follow the inputs far more closely if these were angles, if they stood a few rows further up or down, or if
// the outputs had a sign. The first of these that holds; of a sample of the rows.
[[nodiscard]] std::optional<Finding> find_misread_column(const Dataset& record);

}  // namespace proofmass
