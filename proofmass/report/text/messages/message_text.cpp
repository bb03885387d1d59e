// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/messages/message_text.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "proofmass/report/text/messages/zh_internal.hpp"

namespace proofmass {
namespace {

using Catalogue = std::unordered_map<std::string_view, std::string_view>;

Catalogue all_chinese_messages() {
  Catalogue all;
  for (const auto& messages :
       {chinese_core_messages(), chinese_system_messages(), chinese_record_messages(),
        chinese_stand_messages(), chinese_identify_messages(), chinese_pipeline_messages(),
        chinese_report_messages(), chinese_program_messages()}) {
    for (const ChineseMessage& message : messages) all.emplace(message.english, message.chinese);
  }
  return all;
}

bool is_latin(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

// The three bytes of a Chinese character in UTF-8.
bool begins_chinese(std::string_view text) {
  return text.size() >= 3 && text.front() >= '\xe4' && text.front() <= '\xe9';
}

bool ends_chinese(std::string_view text) {
  return text.size() >= 3 && begins_chinese(text.substr(text.size() - 3));
}

// A space where Latin letters or digits meet Chinese characters.
void append_spaced(std::string& text, std::string_view more) {
  if (text.empty() || more.empty()) {
    text += more;
    return;
  }
  const bool meet =
      (is_latin(text.back()) && begins_chinese(more)) || (ends_chinese(text) && is_latin(more.front()));
  text.append(meet ? " " : "").append(more);
}

}  // namespace

std::string_view chinese_words(std::string_view english) {
  static const Catalogue catalogue = all_chinese_messages();
  const auto found = catalogue.find(english);
  return found == catalogue.end() ? std::string_view() : found->second;
}

std::string with_values(std::string_view words, std::span<const std::string> values) {
  std::string text;
  std::size_t from = 0;
  std::size_t next = 0;
  for (MessagePlace place = next_place(words, 0); place.found(); place = next_place(words, from)) {
    append_spaced(text, words.substr(from, place.begin - from));
    std::size_t number = next++;
    std::from_chars(words.data() + place.begin + 1, words.data() + place.end - 1, number);
    if (number < values.size()) append_spaced(text, values[number]);
    from = place.end;
  }
  append_spaced(text, words.substr(from));
  return text;
}

std::string message_text(const Message& message, Language language) {
  if (language == Language::en || message.is_verbatim()) return message.english();
  const std::string_view words = chinese_words(message.words());
  std::vector<std::string> values;
  for (const Message& value : message.values()) values.push_back(message_text(value, language));
  return with_values(words.empty() ? std::string_view(message.words()) : words, values);
}

}  // namespace proofmass
