// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "proofmass/core/ending.hpp"
#include "proofmass/report/json/node_internal.hpp"

namespace proofmass {

// Status, the sentence in English, and what it says as data.
[[nodiscard]] nlohmann::ordered_json json_of(const Ending& ending);

// The reverse. The sentence stands for data that are missing, or that this version does not know. Throws a
// bad-data Error that names the key.
[[nodiscard]] Ending ending_of(const JsonNode& node);

}  // namespace proofmass
