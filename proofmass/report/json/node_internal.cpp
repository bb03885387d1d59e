// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/json/node_internal.hpp"

#include <fmt/format.h>

#include "proofmass/core/error.hpp"

namespace proofmass {

namespace {
constexpr std::size_t kLongestPath = 120;  // characters; members may have any name
}  // namespace

JsonNode::JsonNode(const Json& json, std::string source, std::string path)
    : json_(&json), source_(std::move(source)), path_(std::move(path)) {}

void JsonNode::fail(const Message& expected) const {
  const std::string found = json_->dump(-1, ' ', true, Json::error_handler_t::replace);
  throw Error(ErrorKind::bad_data, message("{}: {}: found {}, expected {}", source_,
                                           path_.empty() ? Message("the document")
                                                         : message("key '{}'", excerpt(path_, kLongestPath)),
                                           excerpt(found), expected));
}

std::string JsonNode::path_of(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

std::optional<JsonNode> JsonNode::find(const std::string& key) const {
  if (!json_->is_object()) fail("an object");
  const auto found = json_->find(key);
  if (found == json_->end()) return std::nullopt;
  return JsonNode(*found, source_, path_of(key));
}

JsonNode JsonNode::at(const std::string& key) const {
  auto found = find(key);
  if (!found) {
    throw Error(ErrorKind::bad_data,
                message("{}: key '{}' is missing", source_, excerpt(path_of(key), kLongestPath)));
  }
  return *std::move(found);
}

std::vector<JsonNode> JsonNode::items() const {
  if (!json_->is_array()) fail("an array");
  std::vector<JsonNode> nodes;
  nodes.reserve(json_->size());
  for (std::size_t k = 0; k < json_->size(); ++k) {
    nodes.emplace_back((*json_)[k], source_, fmt::format("{}[{}]", path_, k));
  }
  return nodes;
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::members() const {
  if (!json_->is_object()) fail("an object");
  std::vector<std::pair<std::string, JsonNode>> nodes;
  for (const auto& [key, value] : json_->items()) {
    nodes.emplace_back(key, JsonNode(value, source_, path_of(key)));
  }
  return nodes;
}

bool JsonNode::is_null() const { return json_->is_null(); }
bool JsonNode::is_text() const { return json_->is_string(); }

double JsonNode::number() const {
  if (!json_->is_number()) fail("a number");
  return json_->get<double>();
}

std::uint64_t JsonNode::count() const {
  if (!json_->is_number_unsigned()) fail("a whole number of at least 0");
  return json_->get<std::uint64_t>();
}

std::string JsonNode::text() const {
  if (!json_->is_string()) fail("a string");
  return json_->get<std::string>();
}

bool JsonNode::flag() const {
  if (!json_->is_boolean()) fail("true or false");
  return json_->get<bool>();
}

std::vector<double> JsonNode::numbers() const {
  std::vector<double> values;
  for (const JsonNode& item : items()) values.push_back(item.number());
  return values;
}

}  // namespace proofmass
