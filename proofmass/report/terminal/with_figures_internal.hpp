// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>

#include "proofmass/report/text/language.hpp"

namespace proofmass {

// The words with figures in the places of {}.
template <typename... Figures>
[[nodiscard]] std::string with_figures(const Words& words, Language language, const Figures&... figures) {
  return fmt::vformat(words.in(language), fmt::make_format_args(figures...));
}

}  // namespace proofmass
