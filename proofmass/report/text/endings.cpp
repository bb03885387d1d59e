// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/endings.hpp"

#include <vector>

#include "proofmass/report/text/sentence.hpp"

namespace proofmass {
namespace {

constexpr Words kThen{"; ", "；"};
constexpr Words kBetween{", ", "、"};

std::string joined(std::span<const EndingPart> parts, const Words& between, Language language);

std::string words_of(const EndingPart& part, Language language) {
  std::vector<Figure> figures = part.figures;
  if (!part.parts.empty()) {
    figures.emplace_back("parts", joined(part.parts, kThen, language));
    figures.emplace_back("list", joined(part.parts, kBetween, language));
  }
  return filled(ending_words(part.code).in(language), figures, nullptr, language)
      .value_or(plain_text(to_string(part.code), figures));
}

std::string joined(std::span<const EndingPart> parts, const Words& between, Language language) {
  std::string text;
  for (const EndingPart& part : parts)
    text.append(text.empty() ? "" : between.in(language)).append(words_of(part, language));
  return text;
}

}  // namespace

std::string sentence(std::span<const EndingPart> parts, Language language) {
  return joined(parts, kThen, language);
}

}  // namespace proofmass
