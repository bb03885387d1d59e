// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "proofmass/core/finding.hpp"
#include "proofmass/report/json/node_internal.hpp"

namespace proofmass {

// Code, severity, terms, lines, figures, and the sentence in English.
[[nodiscard]] nlohmann::ordered_json json_of(const Finding& finding);
[[nodiscard]] nlohmann::ordered_json json_of(std::span<const Finding> findings);

// Figures by name, and the reverse.
[[nodiscard]] nlohmann::ordered_json json_of_figures(std::span<const Figure> figures);
[[nodiscard]] std::vector<Figure> figures_of(const JsonNode& node);

// The reverse; the sentences, which follow from the rest, are passed over. A code that this version does not
// know comes back as its sentence. Throws a bad-data Error that names the key.
[[nodiscard]] Finding finding_of(const JsonNode& node);
[[nodiscard]] std::vector<Finding> findings_of(const JsonNode& node);

}  // namespace proofmass
