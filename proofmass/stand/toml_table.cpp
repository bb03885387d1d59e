// SPDX-License-Identifier: Apache-2.0
#include "proofmass/stand/toml_table.hpp"

#include <toml++/toml.h>

#include <cmath>
#include <set>
#include <sstream>

#include "proofmass/files/text_file.hpp"

namespace proofmass {
namespace {

constexpr std::size_t kMostBytes = std::size_t{16} << 20U;  // size limit of a plan

std::string as_text(const toml::node& node) {
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return std::move(text).str();
}

std::optional<double> finite_number(const toml::node& node) {
  if (!node.is_number()) return std::nullopt;
  const auto value = node.value<double>();
  return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace

struct TomlTable::State {
  std::shared_ptr<const toml::table> root;  // owns the table that `here` points to
  const toml::table* here = nullptr;
  std::string file;
  std::string prefix;  // "noise." for the keys of [noise]
  std::set<std::string, std::less<>> asked;

  const toml::node* find(std::string_view key) {
    asked.emplace(key);
    return here->get(key);
  }
  [[nodiscard]] Place place(const toml::node* node, std::string_view key) const {
    std::string path = prefix + std::string(key);
    if (key.empty() && !path.empty()) path.pop_back();
    const toml::node& nearest = node != nullptr ? *node : *here;
    return {.file = file, .row = nearest.source().begin.line, .column = std::move(path), .is_key = true};
  }
  [[nodiscard]] TomlTable child(const toml::table& table, const std::string& key) const {
    return TomlTable(std::make_shared<State>(
        State{.root = root, .here = &table, .file = file, .prefix = prefix + key + ".", .asked = {}}));
  }
};

TomlTable::TomlTable(std::shared_ptr<State> state) : state_(std::move(state)) {}

TomlTable TomlTable::read(const std::filesystem::path& path) {
  return parse(read_text_file(path, "a readable TOML file", kMostBytes), path.string());
}

TomlTable TomlTable::parse(std::string_view text, const std::string& file) {
  try {
    auto root = std::make_shared<const toml::table>(toml::parse(text, file));
    const toml::table* const here = root.get();
    return TomlTable(std::make_shared<State>(
        State{.root = std::move(root), .here = here, .file = file, .prefix = {}, .asked = {}}));
  } catch (const toml::parse_error& failure) {
    throw bad_data({.file = file, .row = failure.source().begin.line, .column = {}}, {},
                   message("TOML: {}", failure.description()));
  }
}

std::optional<double> TomlTable::number(std::string_view key) const {
  const toml::node* const node = state_->find(key);
  if (node == nullptr) return std::nullopt;
  const auto value = finite_number(*node);
  if (!value) throw error(key, "a finite number");
  return value;
}

std::optional<std::int64_t> TomlTable::integer(std::string_view key) const {
  const toml::node* const node = state_->find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_integer()) throw error(key, "an integer");
  return node->value<std::int64_t>();
}

std::optional<std::string> TomlTable::text(std::string_view key) const {
  const toml::node* const node = state_->find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_string()) throw error(key, "a string");
  return node->value<std::string>();
}

std::optional<bool> TomlTable::boolean(std::string_view key) const {
  const toml::node* const node = state_->find(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_boolean()) throw error(key, "true or false");
  return node->value<bool>();
}

std::optional<std::vector<double>> TomlTable::numbers(std::string_view key) const {
  const toml::node* const node = state_->find(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* const array = node->as_array();
  if (array == nullptr) throw error(key, "a list of finite numbers");
  std::vector<double> values;
  for (const toml::node& element : *array) {
    const auto value = finite_number(element);
    if (!value) throw bad_data(state_->place(&element, key), as_text(element), "a list of finite numbers");
    values.push_back(*value);
  }
  return values;
}

std::optional<TomlTable> TomlTable::table(std::string_view key) const {
  const toml::node* const node = state_->find(key);
  if (node == nullptr) return std::nullopt;
  const toml::table* const table = node->as_table();
  if (table == nullptr) throw error(key, "a table");
  return state_->child(*table, std::string(key));
}

std::optional<std::vector<TomlTable>> TomlTable::tables(std::string_view key) const {
  const toml::node* const node = state_->find(key);
  if (node == nullptr) return std::nullopt;
  const toml::array* const array = node->as_array();
  if (array == nullptr) throw error(key, "a list of tables");
  std::vector<TomlTable> list;
  for (const toml::node& element : *array) {
    const toml::table* const table = element.as_table();
    if (table == nullptr) throw bad_data(state_->place(&element, key), as_text(element), "a list of tables");
    list.push_back(state_->child(*table, std::string(key) + "[" + std::to_string(list.size() + 1) + "]"));
  }
  return list;
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> list;
  for (const auto& [key, node] : *state_->here) list.emplace_back(key.str());
  return list;
}

Error TomlTable::error(std::string_view key, const Message& expected) const {
  const toml::node* const node = key.empty() ? nullptr : state_->here->get(key);
  return bad_data(state_->place(node, key), node != nullptr ? as_text(*node) : std::string(), expected);
}

void TomlTable::finish() const {
  for (const auto& [key, node] : *state_->here) {
    if (state_->asked.contains(key.str())) continue;
    std::string known;
    for (const auto& name : state_->asked) known += (known.empty() ? "" : ", ") + name;
    throw bad_data(state_->place(&node, key.str()), key.str(), message("one of the keys {}", known));
  }
}

}  // namespace proofmass
