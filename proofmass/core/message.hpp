// SPDX-License-Identifier: Apache-2.0
// The words of an error as data: a pattern in English with the values in its places, so that a program can
// say it in another language (report/text/messages).
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace proofmass {

class Message {
 public:
  Message() = default;  // nothing to say
  // Words without values. Not a pointer: words chosen by a condition would be hidden from
  // the test that looks for those without a translation.
  template <std::size_t size>
  // NOLINTNEXTLINE(google-explicit-constructor,cppcoreguidelines-avoid-c-arrays,modernize-avoid-c-arrays)
  Message(const char (&words)[size]) : words_(words) {}
  // A name, a number, what a file holds: the same in every language.
  [[nodiscard]] static Message verbatim(std::string_view text);
  // Words of another program, which may be known in another language.
  [[nodiscard]] static Message foreign(std::string_view words);
  // Use message() below.
  Message(std::string_view pattern, std::vector<Message> values)
      : words_(pattern), values_(std::move(values)) {}

  [[nodiscard]] bool empty() const noexcept { return words_.empty(); }
  [[nodiscard]] bool is_verbatim() const noexcept { return verbatim_; }
  // In English, with a place in braces for each value.
  [[nodiscard]] const std::string& words() const noexcept { return words_; }
  [[nodiscard]] const std::vector<Message>& values() const noexcept { return values_; }
  [[nodiscard]] std::string english() const;

 private:
  std::string words_;
  std::vector<Message> values_;
  bool verbatim_ = false;
};

// A place for a value: "{}", or as {fmt} has it for a number that is not whole: "{:.3g}".
struct MessagePlace {
  std::size_t begin = std::string_view::npos;
  std::size_t end = std::string_view::npos;
  [[nodiscard]] constexpr bool found() const noexcept { return begin != std::string_view::npos; }
};

// The first place in a pattern from a position on.
[[nodiscard]] constexpr MessagePlace next_place(std::string_view pattern, std::size_t from) noexcept {
  const std::size_t begin = pattern.find('{', from);
  if (begin == std::string_view::npos) return {};
  return {begin, pattern.find('}', begin) + 1};
}

// A pattern that was found to fit its values when it was compiled.
template <typename... Values>
class MessagePattern {
 public:
  // NOLINTNEXTLINE(google-explicit-constructor)
  consteval MessagePattern(const char* words) : words_(words) {
    const bool formattable[] = {std::is_floating_point_v<Values>..., false};  // NOLINT(*-avoid-c-arrays)
    std::size_t count = 0;
    for (MessagePlace place = next_place(words_, 0); place.found(); place = next_place(words_, place.end)) {
      if (count == sizeof...(Values)) throw std::invalid_argument("more places than values");
      if (place.end - place.begin > 2 && !formattable[count])
        throw std::invalid_argument("a format for what is no fraction");
      ++count;
    }
    if (count < sizeof...(Values)) throw std::invalid_argument("more values than places");
  }
  [[nodiscard]] std::string_view words() const noexcept { return words_; }

 private:
  std::string_view words_;
};

[[nodiscard]] Message shown(std::string_view place, double value);
[[nodiscard]] Message shown(std::string_view place, std::int64_t value);
[[nodiscard]] Message shown(std::string_view place, std::uint64_t value);

template <typename Value>
[[nodiscard]] Message message_value(std::string_view place, const Value& value) {
  if constexpr (std::is_same_v<Value, Message>) {
    return value;
  } else if constexpr (std::is_floating_point_v<Value>) {
    return shown(place, static_cast<double>(value));
  } else if constexpr (std::is_integral_v<Value>) {
    static_assert(!std::is_same_v<Value, bool> && !std::is_same_v<Value, char>);
    using Whole = std::conditional_t<std::is_signed_v<Value>, std::int64_t, std::uint64_t>;
    return shown(place, static_cast<Whole>(value));
  } else {
    return Message::verbatim(value);
  }
}

// A Message of a pattern and its values. The pattern is a literal, for the test that looks for those without
// a translation.
template <typename... Values>
[[nodiscard]] Message message(MessagePattern<std::type_identity_t<Values>...> pattern,
                              const Values&... values) {
  std::vector<Message> shown_values;
  shown_values.reserve(sizeof...(Values));
  [[maybe_unused]] MessagePlace place;
  [[maybe_unused]] const auto add = [&](const auto& value) {
    place = next_place(pattern.words(), place.found() ? place.end : 0);
    shown_values.push_back(
        message_value(pattern.words().substr(place.begin, place.end - place.begin), value));
  };
  (add(values), ...);
  return {pattern.words(), std::move(shown_values)};
}

// "1 row", "2 rows".
[[nodiscard]] Message amount_of(std::size_t count, const Message& one, const Message& several);

}  // namespace proofmass
