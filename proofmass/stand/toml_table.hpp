// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proofmass/core/error.hpp"

namespace proofmass {

// A table of a TOML file, read strictly. Every getter returns an empty value when the key is absent, and
// throws a bad-data Error with file, line and key when the value has another type. finish() throws when the
// table has keys that no getter was called for.
class TomlTable {
 public:
  // The root table. Throws a bad-data Error when the file cannot be read or is not TOML.
  [[nodiscard]] static TomlTable read(const std::filesystem::path& path);
  // The same from text; `name` is the file name in messages.
  [[nodiscard]] static TomlTable parse(std::string_view text, const std::string& name);

  [[nodiscard]] std::optional<double> number(
      std::string_view key) const;  // finite; integers count as numbers
  [[nodiscard]] std::optional<std::int64_t> integer(std::string_view key) const;
  [[nodiscard]] std::optional<std::string> text(std::string_view key) const;
  [[nodiscard]] std::optional<bool> boolean(std::string_view key) const;
  [[nodiscard]] std::optional<std::vector<double>> numbers(std::string_view key) const;
  [[nodiscard]] std::optional<TomlTable> table(std::string_view key) const;
  [[nodiscard]] std::optional<std::vector<TomlTable>> tables(std::string_view key) const;  // [[key]]

  [[nodiscard]] std::vector<std::string> keys() const;  // in alphabetical order

  // An Error about the value of a key, about its absence or, with an empty key, about the table itself.
  [[nodiscard]] Error error(std::string_view key, const Message& expected) const;

  // Throws when the table has a key that no getter was called for.
  void finish() const;

 private:
  struct State;
  explicit TomlTable(std::shared_ptr<State> state);
  std::shared_ptr<State> state_;
};

}  // namespace proofmass
