// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/message.hpp"

#include <fmt/format.h>

namespace proofmass {

Message Message::verbatim(std::string_view text) {
  Message made;
  made.words_ = text;
  made.verbatim_ = true;
  return made;
}

Message Message::foreign(std::string_view words) { return {words, {}}; }

std::string Message::english() const {
  if (values_.empty()) return words_;
  const std::string_view words = words_;
  std::string text;
  std::size_t from = 0;
  for (const Message& value : values_) {
    const MessagePlace place = next_place(words, from);
    if (!place.found()) break;
    text.append(words.substr(from, place.begin - from)).append(value.english());
    from = place.end;
  }
  return text.append(words.substr(from));
}

Message shown(std::string_view place, double value) {
  return Message::verbatim(fmt::format(fmt::runtime(place), value));
}

Message shown(std::string_view place, std::int64_t value) {
  return Message::verbatim(fmt::format(fmt::runtime(place), value));
}

Message shown(std::string_view place, std::uint64_t value) {
  return Message::verbatim(fmt::format(fmt::runtime(place), value));
}

Message amount_of(std::size_t count, const Message& one, const Message& several) {
  return message("{} {}", count, count == 1 ? one : several);
}

}  // namespace proofmass
