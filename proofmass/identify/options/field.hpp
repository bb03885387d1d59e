// SPDX-License-Identifier: Apache-2.0
// Options as tables: what a field of an options struct is called, may hold and means is written once, beside
// the struct. Flags, --help, provenance and docs/commands.md are made from the tables.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <tuple>

namespace proofmass {

// A choice and its name.
template <typename Value>
struct Word {
  std::string_view text;
  Value value;
};

inline constexpr std::array kSwitchWords{Word<bool>{"on", true}, Word<bool>{"off", false}};

// The numbers that a field may hold.
template <typename Number>
struct Range {
  Number low{};
  Number high = std::numeric_limits<Number>::max();
  bool above_low = false;   // low itself is not allowed
  bool below_high = false;  // high itself is not allowed
  [[nodiscard]] constexpr bool holds(Number number) const noexcept {
    return (above_low ? number > low : number >= low) && (below_high ? number < high : number <= high);
  }
};

[[nodiscard]] constexpr Range<double> between(double low, double high) { return {.low = low, .high = high}; }
[[nodiscard]] constexpr Range<double> at_least(double low) { return {.low = low}; }
[[nodiscard]] constexpr Range<double> above(double low, double high = std::numeric_limits<double>::max()) {
  return {.low = low, .high = high, .above_low = true};
}
[[nodiscard]] constexpr Range<double> below(double low, double high) {
  return {.low = low, .high = high, .below_high = true};
}
inline constexpr std::size_t kMostIterations = 1'000'000'000;
inline constexpr std::size_t kMostMembers = 100'000;  // of a population, starts, repeats
inline constexpr std::size_t kMostUnits = 1000;       // hidden units, neurons, layers
[[nodiscard]] constexpr Range<std::size_t> whole(std::size_t low, std::size_t high = kMostIterations) {
  return {.low = low, .high = high};
}

// What few fields have beside name, member, help and domain.
struct FieldNotes {
  std::string_view place{};           // where the documentation explains it: "pso-bp.md#the-swarm"
  std::string_view unit{};            // that the value is written in, where it has one
  double per_unit = 1.0;              // written value = stored value * per_unit
  std::string_view absent{};          // the word for a field that holds nothing
  std::string_view former{};          // an earlier name, which is still understood
  std::span<const double> figures{};  // that stand in the help where it has {}, in order
};

// Domain: Range<double>, Range<std::size_t>, or the words of a choice.
template <typename Owner, typename Value, typename Domain>
struct Field {
  std::string_view name;  // "outlier-limit"
  Value Owner::*member;
  std::string_view help;  // one line, as help_text fills it in
  Domain domain;
  FieldNotes notes;
};

template <typename Owner, typename Value, typename Number>
[[nodiscard]] constexpr auto field(std::string_view name, Value Owner::*member, std::string_view help,
                                   const Range<Number>& range, const FieldNotes& notes = {}) {
  return Field<Owner, Value, Range<Number>>{name, member, help, range, notes};
}
template <typename Owner, typename Value, std::size_t size>
[[nodiscard]] constexpr auto field(std::string_view name, Value Owner::*member, std::string_view help,
                                   const std::array<Word<Value>, size>& words, const FieldNotes& notes = {}) {
  return Field<Owner, Value, std::span<const Word<Value>>>{name, member, help, words, notes};
}

// Fields of a struct inside the struct.
template <typename Owner, typename Inner, typename Fields>
struct Group {
  Inner Owner::*member;
  Fields fields;
};
template <typename Owner, typename Inner, typename Fields>
[[nodiscard]] constexpr auto group(Inner Owner::*member, const Fields& fields) {
  return Group<Owner, Inner, Fields>{member, fields};
}

// Calls visit(field, value) for each field, those of groups included, in the order of the table.
template <typename Options, typename Fields, typename Visit>
constexpr void for_each_field(Options& options, const Fields& fields, Visit&& visit) {
  const auto one = [&](const auto& entry) {
    if constexpr (requires { entry.fields; }) {
      for_each_field(options.*entry.member, entry.fields, visit);
    } else {
      visit(entry, options.*entry.member);
    }
  };
  std::apply([&one](const auto&... entries) { (one(entries), ...); }, fields);
}

}  // namespace proofmass
