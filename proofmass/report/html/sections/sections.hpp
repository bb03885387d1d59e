// SPDX-License-Identifier: Apache-2.0
// The parts of a report of an identification, one a file. A part without data is absent.
#pragma once

#include <span>

#include "proofmass/report/html/page/section.hpp"

namespace proofmass::html {

using MakeSection = std::optional<Section> (*)(const IdentificationContext&);

// All of them, in the order of the page. To add a part: its file, and its line here and there.
[[nodiscard]] std::span<const MakeSection> identification_sections();

[[nodiscard]] std::optional<Section> verdict_section(const IdentificationContext& context);
[[nodiscard]] std::optional<Section> coefficients_section(const IdentificationContext& context);
[[nodiscard]] std::optional<Section> scores_section(const IdentificationContext& context);
[[nodiscard]] std::optional<Section> fit_section(const IdentificationContext& context);
[[nodiscard]] std::optional<Section> residuals_section(const IdentificationContext& context);
[[nodiscard]] std::optional<Section> distribution_section(const IdentificationContext& context);
[[nodiscard]] std::optional<Section> nonlinearity_section(const IdentificationContext& context);
[[nodiscard]] std::optional<Section> training_section(const IdentificationContext& context);
[[nodiscard]] std::optional<Section> test_rows_section(const IdentificationContext& context);
[[nodiscard]] std::optional<Section> correlations_section(const IdentificationContext& context);
[[nodiscard]] std::optional<Section> influence_section(const IdentificationContext& context);
[[nodiscard]] std::optional<Section> excitation_section(const IdentificationContext& context);
[[nodiscard]] std::optional<Section> ending_section(const IdentificationContext& context);
[[nodiscard]] std::optional<Section> settings_section(const IdentificationContext& context);

}  // namespace proofmass::html
