// SPDX-License-Identifier: Apache-2.0
// The words of all Messages that the sources make: the literals that stand where a Message is made or taken.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace proofmass::test {

// Functions and constructors, each with the places of the arguments that are Messages.
using MessageTakers = std::map<std::string, std::set<std::size_t>>;

// The program's sources, without comments.
inline std::vector<std::string> program_sources() {
  namespace fs = std::filesystem;
  static const std::regex kComment(R"((^|\n)\s*//[^\n]*)");
  std::vector<std::string> texts;
  for (const char* const folder : {"proofmass", "apps/proofmass"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(PROOFMASS_SOURCE_DIR) / folder)) {
      const std::string name = entry.path().filename().string();
      const bool source = name.ends_with(".cpp") || name.ends_with(".hpp");
      if (!source || name.ends_with("_test.cpp") || entry.path().parent_path().filename() == "messages")
        continue;
      std::ifstream file(entry.path());
      const std::string text{std::istreambuf_iterator<char>(file), {}};
      texts.push_back(std::regex_replace(text, kComment, "$1"));
    }
  }
  return texts;
}

// Those that take a Message by their declaration, besides those that make one.
inline MessageTakers message_takers(const std::vector<std::string>& sources) {
  static const std::regex kDeclared(
      R"((\w+)(?: = \[&?\])?\(([^(){};"]*\bconst (?:Message|FoundText)& \w+[^(){};"]*)\))");
  MessageTakers takers{{"message", {0}}, {"Message", {0}}, {"FoundText", {0}}, {"Error", {1}}};
  for (const std::string& text : sources) {
    for (std::sregex_iterator at(text.begin(), text.end(), kDeclared), end; at != end; ++at) {
      const std::string parameters = (*at)[2];
      std::size_t place = 0;
      std::size_t from = 0;
      while (from <= parameters.size()) {
        const std::size_t comma = std::min(parameters.find(',', from), parameters.size());
        const std::string parameter = parameters.substr(from, comma - from);
        const bool takes = parameter.find("const Message&") != std::string::npos ||
                           parameter.find("const FoundText&") != std::string::npos;
        if (takes) takers[(*at)[1]].insert(place);
        ++place;
        from = comma + 1;
      }
    }
  }
  return takers;
}

// The arguments of a call, from behind its bracket: the text of those that are literals alone, else empty.
inline std::vector<std::string> literal_arguments(std::string_view code) {
  std::vector<std::string> arguments(1);
  bool literal = true;
  int depth = 1;
  const auto finish = [&] {
    if (!literal) arguments.back().clear();
    literal = true;
  };
  for (std::size_t at = 0; at < code.size(); ++at) {
    const char c = code[at];
    if (c == '"') {
      for (++at; at < code.size() && code[at] != '"'; ++at) {
        if (code[at] == '\\') ++at;
        if (depth == 1) arguments.back() += code[at];
      }
    } else if (c == '\'') {
      at += code[at + 1] == '\\' ? 3U : 2U;
      literal = false;
    } else if (c == ',' && depth == 1) {
      finish();
      arguments.emplace_back();
    } else if (std::string_view("([{").find(c) != std::string_view::npos) {
      ++depth;
      literal = false;
    } else if (std::string_view(")]}").find(c) != std::string_view::npos) {
      if (--depth == 0) break;
    } else if (std::isspace(static_cast<unsigned char>(c)) == 0) {
      literal = false;
    }
  }
  finish();
  return arguments;
}

inline std::set<std::string> message_patterns() {
  static const std::regex kCall(R"((\w+)\()");
  const std::vector<std::string> sources = program_sources();
  const MessageTakers takers = message_takers(sources);
  std::set<std::string> patterns;
  for (const std::string& text : sources) {
    for (std::sregex_iterator at(text.begin(), text.end(), kCall), end; at != end; ++at) {
      const auto taker = takers.find((*at)[1]);
      if (taker == takers.end()) continue;
      const auto behind = static_cast<std::size_t>(at->position() + at->length());
      const std::vector<std::string> arguments = literal_arguments(std::string_view(text).substr(behind));
      for (const std::size_t place : taker->second) {
        if (place < arguments.size() && !arguments[place].empty()) patterns.insert(arguments[place]);
      }
    }
  }
  return patterns;
}

}  // namespace proofmass::test
