// SPDX-License-Identifier: Apache-2.0
// What tables and headings on a terminal say, in every language.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "proofmass/core/ending.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/report/text/language.hpp"

namespace proofmass {

[[nodiscard]] Words severity_words(Severity severity) noexcept;
[[nodiscard]] Words status_words(EndingStatus status) noexcept;

// Words that reports say too are Labels (report/text/label.hpp). This one is shorter in a table.
inline constexpr Words kTrainingPart{"train", "训练集"};

// "2 rows", "2 行": both words of the noun for one.
[[nodiscard]] std::string amount(std::size_t count, const Words& noun, Language language);

// The header of a table.
[[nodiscard]] std::vector<std::string> header_in(Language language, std::initializer_list<Words> names);

}  // namespace proofmass
