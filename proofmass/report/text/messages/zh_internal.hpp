// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace proofmass {

// The words of a Message in English and in Chinese. The Chinese has each value in its place, or, where their
// order is another, by its number: {1} before {0}.
struct ChineseMessage {
  std::string_view english;
  std::string_view chinese;
};

// By the module whose errors they are; of the core those that all compose theirs of.
[[nodiscard]] std::span<const ChineseMessage> chinese_core_messages() noexcept;
[[nodiscard]] std::span<const ChineseMessage> chinese_system_messages() noexcept;
[[nodiscard]] std::span<const ChineseMessage> chinese_record_messages() noexcept;
[[nodiscard]] std::span<const ChineseMessage> chinese_stand_messages() noexcept;
[[nodiscard]] std::span<const ChineseMessage> chinese_identify_messages() noexcept;
[[nodiscard]] std::span<const ChineseMessage> chinese_pipeline_messages() noexcept;
[[nodiscard]] std::span<const ChineseMessage> chinese_report_messages() noexcept;
[[nodiscard]] std::span<const ChineseMessage> chinese_program_messages() noexcept;

// Empty when there is none.
[[nodiscard]] std::string_view chinese_words(std::string_view english);

// The words with each value in its place.
[[nodiscard]] std::string with_values(std::string_view words, std::span<const std::string> values);

}  // namespace proofmass
