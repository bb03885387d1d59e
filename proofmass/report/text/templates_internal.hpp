// SPDX-License-Identifier: Apache-2.0
// The sentences of the catalogue before their figures are put in: tests compare those of the languages.
#pragma once

#include <span>
#include <string_view>

#include "proofmass/core/finding.hpp"

namespace proofmass {

// The words for a figure that is the name of a choice.
struct NamedPhrase {
  std::string_view figure;
  std::string_view word;
  std::string_view phrase;
};

// Empty where the sentence is made of a reason.
[[nodiscard]] std::string_view english_template(Code code) noexcept;
[[nodiscard]] std::string_view chinese_template(Code code) noexcept;

// Of a robust scale on few rows, in place of that of its code.
[[nodiscard]] std::string_view english_scale_of_few_rows() noexcept;
[[nodiscard]] std::string_view chinese_scale_of_few_rows() noexcept;

[[nodiscard]] std::string_view english_phrase(std::string_view figure, std::string_view word) noexcept;
[[nodiscard]] std::string_view chinese_phrase(std::string_view figure, std::string_view word) noexcept;

// Those about faults of records and fits.
[[nodiscard]] std::span<const NamedPhrase> english_diagnosis_phrases() noexcept;

}  // namespace proofmass
