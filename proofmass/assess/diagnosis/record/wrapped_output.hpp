// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"

namespace proofmass {

// Says when outputs, in the order of their Ai, jump back by one constant, once or more, and follow the inputs
// at least three times as closely when as many of it are added: signed counts read as unsigned, or a counter
// or converter that ran over. Counts jump by 2^n, n from 8 to 32.
[[nodiscard]] std::optional<Finding> find_wrapped_output(const Dataset& record);

}  // namespace proofmass
