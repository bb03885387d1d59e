// SPDX-License-Identifier: Apache-2.0
// Sentences with the figures of a finding in them, in whatever language.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "proofmass/core/finding.hpp"
#include "proofmass/report/text/language.hpp"

namespace proofmass {

// The words for a figure that is the name of a choice, with figures in braces; empty where it has none.
using Phrase = std::string_view (*)(std::string_view figure, std::string_view word) noexcept;

// The sentence with each figure in the place of its name in braces, formatted as fmt does, and the names of
// the finding's terms in place of {terms}, the numbers of its lines in place of {lines}. The format of a
// number is passed over where the figure is a word. "{count:?row has|rows have}" is the first words where the
// count is one, the others elsewhere. Code and figures alone when the finding, read from a
// file, lacks a figure of the sentence.
[[nodiscard]] std::string filled(std::string_view sentence, const Finding& finding, Phrase phrase = nullptr,
                                 Language language = Language::en);

// Likewise with these figures alone; nothing when one is missing.
[[nodiscard]] std::optional<std::string> filled(std::string_view sentence, std::span<const Figure> figures,
                                                Phrase phrase, Language language);

// A code by its name and figures, where there are no words for it.
[[nodiscard]] std::string plain_text(std::string_view code, std::span<const Figure> figures);

// "Kii, Koq", in Chinese "Kii、Koq".
[[nodiscard]] std::string listed_names(const TermList& terms, Language language);

[[nodiscard]] bool has_figure(const Finding& finding, std::string_view name) noexcept;

}  // namespace proofmass
