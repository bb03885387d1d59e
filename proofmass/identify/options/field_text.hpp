// SPDX-License-Identifier: Apache-2.0
// The values of fields as text, and back.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/options/field.hpp"

namespace proofmass {

// The shortest text t for which t / per_unit is the value again.
[[nodiscard]] std::string number_as_text(double value, double per_unit = 1.0);

// The number that a text is, from its first character to its last. Throws outside_range.
[[nodiscard]] double read_number(std::string_view name, std::string_view text, const Range<double>& range,
                                 std::string_view or_word = {});
[[nodiscard]] std::size_t read_number(std::string_view name, std::string_view text,
                                      const Range<std::size_t>& range, std::string_view or_word = {});

// "NAME: found 'TEXT', expected a number from … to …", with the word that would do in place of a number.
[[nodiscard]] Error outside_range(std::string_view name, std::string_view text, const Range<double>& range,
                                  std::string_view or_word = {});
[[nodiscard]] Error outside_range(std::string_view name, std::string_view text,
                                  const Range<std::size_t>& range, std::string_view or_word = {});

// "NAME: found 'TEXT', expected one of WORDS".
[[nodiscard]] Error not_one_of(std::string_view name, std::string_view text, std::string_view words);

// "from 0 to 1", "more than 0", "at least 1".
[[nodiscard]] std::string range_text(const Range<double>& range);
[[nodiscard]] std::string range_text(const Range<std::size_t>& range);

// The help with each {} replaced by the next figure.
[[nodiscard]] std::string help_text(std::string_view help, std::span<const double> figures);

// "a, b, c".
template <typename Words>
[[nodiscard]] std::string list_of(const Words& words, std::string_view separator = ", ") {
  std::string list;
  for (const auto& word : words) list.append(list.empty() ? "" : separator).append(word.text);
  return list;
}

// The word of a value; empty when it has none.
template <typename Words, typename Value>
[[nodiscard]] std::string word_of(const Words& words, const Value& value) {
  for (const auto& word : words) {
    if (word.value == value) return std::string(word.text);
  }
  return {};
}

template <typename Owner, typename Value>
[[nodiscard]] std::string value_text(const Field<Owner, Value, Range<double>>& field, double value) {
  return number_as_text(value, field.notes.per_unit);
}
template <typename Owner, typename Value>
[[nodiscard]] std::string value_text(const Field<Owner, Value, Range<std::size_t>>&, std::size_t value) {
  return std::to_string(value);
}
template <typename Owner, typename Value>
[[nodiscard]] std::string value_text(const Field<Owner, Value, std::span<const Word<Value>>>& field,
                                     Value value) {
  return word_of(field.domain, value);
}
template <typename Owner, typename Value, typename Domain>
[[nodiscard]] std::string value_text(const Field<Owner, std::optional<Value>, Domain>& field,
                                     const std::optional<Value>& value) {
  return value ? value_text(field, *value) : std::string(field.notes.absent);
}

// Takes the value that a text says. Throws a usage Error "NAME: found 'TEXT', expected …".
template <typename Owner, typename Value, typename Domain>
void read_value(const Field<Owner, Value, Domain>& field, Value& value, std::string_view text) {
  if constexpr (requires { value.reset(); }) {
    if (text == field.notes.absent) {
      value.reset();
      return;
    }
  }
  if constexpr (requires { field.domain.low; }) {
    const auto number = read_number(field.name, text, field.domain, field.notes.absent);
    if constexpr (std::is_same_v<Domain, Range<double>>) {
      value = number / field.notes.per_unit;
    } else {
      value = number;
    }
  } else {
    for (const auto& word : field.domain) {
      if (word.text == text) {
        value = word.value;
        return;
      }
    }
    throw not_one_of(field.name, text, list_of(field.domain));
  }
}

// Throws outside_range when a field holds a number that it may not hold.
template <typename Options>
void require_in_range(const Options& options) {
  for_each_field(options, Options::fields, [](const auto& field, const auto& value) {
    if constexpr (requires { field.domain.low; }) {
      bool good = true;
      if constexpr (requires { value.has_value(); }) {
        good = !value || field.domain.holds(*value * static_cast<std::remove_cvref_t<decltype(*value)>>(
                                                         field.notes.per_unit));
      } else {
        good = field.domain.holds(value);
      }
      if (!good) throw outside_range(field.name, value_text(field, value), field.domain, field.notes.absent);
    }
  });
}

}  // namespace proofmass
