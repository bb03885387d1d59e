// SPDX-License-Identifier: Apache-2.0
// Parts of a result file that its reader is put together from. All throw a bad-data Error that names the key.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "proofmass/core/identification.hpp"
#include "proofmass/report/json/node_internal.hpp"

namespace proofmass {

// Absent keys are absent values.
[[nodiscard]] std::optional<double> optional_number(const JsonNode& node, const std::string& key);
[[nodiscard]] std::optional<std::size_t> optional_count(const JsonNode& node, const std::string& key);

[[nodiscard]] Interval interval_of(const JsonNode& node);
[[nodiscard]] TrainedNetwork network_of(const JsonNode& node);
[[nodiscard]] Diagnostics diagnostics_of(const JsonNode& node);
[[nodiscard]] Details details_of(const JsonNode& node);

}  // namespace proofmass
