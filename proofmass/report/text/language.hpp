// SPDX-License-Identifier: Apache-2.0
// The languages in which people read results.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace proofmass {

enum class Language : std::uint8_t { en, zh };  // English, simplified Chinese
inline constexpr std::array kLanguages{Language::en, Language::zh};

// The same words in every language: an entry of the catalogue.
struct Words {
  std::string_view en, zh;
  [[nodiscard]] constexpr std::string_view in(Language language) const noexcept {
    return language == Language::zh ? zh : en;
  }
};

// The same text in every language, with its figures.
struct Text {
  std::string en, zh;
  Text() = default;
  Text(Words words) : en(words.en), zh(words.zh) {}  // NOLINT(google-explicit-constructor): the same text
  Text(std::string english, std::string chinese) : en(std::move(english)), zh(std::move(chinese)) {}
  [[nodiscard]] const std::string& in(Language language) const noexcept {
    return language == Language::zh ? zh : en;
  }
  friend bool operator==(const Text&, const Text&) = default;
};

// A text that is the same in every language: a symbol, a number, a name.
[[nodiscard]] inline Text same_text(const std::string& text) { return {text, text}; }

}  // namespace proofmass
