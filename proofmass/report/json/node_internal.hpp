// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proofmass/core/message.hpp"

namespace proofmass {

// One value of a JSON document with the path that leads to it, so that errors can name it. Every reader
// throws a bad-data Error when the value is not what is asked for. The document must outlive the node.
class JsonNode {
 public:
  using Json = nlohmann::ordered_json;
  JsonNode(const Json& json, std::string source, std::string path = {});

  // "result.json: key 'coefficients[2].value': found \"x\", expected …"
  [[noreturn]] void fail(const Message& expected) const;
  [[nodiscard]] std::optional<JsonNode> find(const std::string& key) const;
  [[nodiscard]] JsonNode at(const std::string& key) const;
  [[nodiscard]] std::vector<JsonNode> items() const;
  [[nodiscard]] std::vector<std::pair<std::string, JsonNode>> members() const;
  [[nodiscard]] bool is_null() const;
  [[nodiscard]] bool is_text() const;
  [[nodiscard]] double number() const;
  [[nodiscard]] std::uint64_t count() const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool flag() const;
  [[nodiscard]] std::vector<double> numbers() const;

 private:
  [[nodiscard]] std::string path_of(const std::string& key) const;
  const Json* json_;
  std::string source_;
  std::string path_;
};

}  // namespace proofmass
