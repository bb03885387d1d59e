// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "proofmass/assess/inspection.hpp"

namespace proofmass {

// An inspection as JSON, schema "proofmass.inspection/1"; numbers as those of a result.
[[nodiscard]] std::string to_json(const Inspection& inspection);

}  // namespace proofmass
