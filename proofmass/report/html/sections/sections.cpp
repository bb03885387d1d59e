// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/html/sections/sections.hpp"

#include <array>

namespace proofmass::html {

std::span<const MakeSection> identification_sections() {
  static constexpr std::array kSections{&verdict_section,      &coefficients_section, &scores_section,
                                        &fit_section,          &residuals_section,    &distribution_section,
                                        &nonlinearity_section, &training_section,     &test_rows_section,
                                        &correlations_section, &influence_section,    &excitation_section,
                                        &ending_section,       &settings_section};
  return kSections;
}

}  // namespace proofmass::html
