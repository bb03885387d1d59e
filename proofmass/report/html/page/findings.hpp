// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "proofmass/core/finding.hpp"
#include "proofmass/report/text/language.hpp"

namespace proofmass::html {

// The figure that shows what was found, by its id; empty where none does.
[[nodiscard]] std::string_view figure_of(const Finding& finding);

// With more words after the sentence.
[[nodiscard]] std::string finding(const Finding& found, const Text& more = {});

// What was found that this figure shows; warnings and notes.
[[nodiscard]] std::string findings_of(std::span<const Finding> all, std::string_view figure);

}  // namespace proofmass::html
