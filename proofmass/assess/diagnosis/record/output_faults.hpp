// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/record/plain_response.hpp"
#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when the outputs end although the inputs of some rows ask for more: a meter that saturates, or folds
// back, with noise on it.
[[nodiscard]] std::optional<Finding> find_saturation(const Dataset& record, const PlainResponse& plain);

// Says when the output hardly changes in rows in sequence whose inputs ask for a change: stuck, with noise.
[[nodiscard]] std::optional<Finding> find_stuck(const Dataset& record, const PlainResponse& plain);

// Says when rows here and there have exactly one output although their inputs ask for others: a reading that
// is missing.
[[nodiscard]] std::optional<Finding> find_repeated_output(const Dataset& record, const PlainResponse& plain);

}  // namespace proofmass
