// SPDX-License-Identifier: Apache-2.0
#include "record_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <thread>

#include "proofmass/core/error.hpp"
#include "proofmass/core/text.hpp"
#include "proofmass/identify/options/field_text.hpp"
#include "proofmass/record/columns.hpp"

namespace proofmass::cli {
namespace {

constexpr std::array kDecimalWords{Word<DecimalMark>{"auto", DecimalMark::automatic},
                                   Word<DecimalMark>{"point", DecimalMark::point},
                                   Word<DecimalMark>{"comma", DecimalMark::comma}};
constexpr std::array kOverloadWords{Word<OverloadPolicy>{"refuse", OverloadPolicy::refuse},
                                    Word<OverloadPolicy>{"leave-out", OverloadPolicy::leave_out}};

template <typename Value, std::size_t size>
void add_choice(CLI::App& verb, const std::string& option, const std::array<Word<Value>, size>& words,
                Value& value, const std::string& help) {
  const auto take = [option, &words, &value](const std::string& text) {
    for (const auto& word : words) {
      if (word.text != text) continue;
      value = word.value;
      return;
    }
    throw not_one_of(option, text, list_of(words));
  };
  verb.add_option_function<std::string>(option, take,
                                        fmt::format("{} (default {})", help, words.front().text))
      ->type_name(list_of(words, "|"))
      ->take_last();
}

// Parts of a list between commas, outside quotes and brackets.
std::vector<std::string> parts_of(std::string_view list) {
  std::vector<std::string> parts(1);
  bool quoted = false;
  int depth = 0;
  for (const char c : list) {
    if (c == '"') quoted = !quoted;
    if (c == '[') ++depth;
    if (c == ']') --depth;
    if (c == ',' && !quoted && depth <= 0) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

std::map<std::string, std::string> renames(const std::vector<std::string>& map) {
  std::map<std::string, std::string> columns;
  std::string last;
  for (const std::string& list : map) {
    last.clear();
    for (const std::string& part : parts_of(list)) {
      const std::size_t equals = part.find('=');
      // A comma may belong to the name of the column: Ai=Specific force, X. The name of a column of a record
      // does not.
      const bool continues = equals == std::string::npos && !last.empty() && !trimmed(part).empty() &&
                             !find_column(trimmed(part));
      if (continues) {
        columns.at(last) += "," + part;
        continue;
      }
      last = equals == std::string::npos ? "" : trimmed(std::string_view(part).substr(0, equals));
      std::string column(equals == std::string::npos ? ""
                                                     : trimmed(std::string_view(part).substr(equals + 1)));
      std::erase(column, '"');
      if (last.empty() || column.empty()) {
        throw usage_error(message("--map: {}", message("found '{}', expected {}", excerpt(part),
                                                       message("NAME=COLUMN, as Ai=ax"))));
      }
      if (!columns.emplace(last, column).second)
        throw usage_error(message("--map: '{}' is given twice", last));
    }
  }
  return columns;
}

}  // namespace

void add_record(CLI::App& verb, RecordFlags& flags, const std::string& name, const std::string& help) {
  verb.add_option(name, flags.path, help)->required();
  verb.add_option(
          "--map", flags.map,
          "Columns of the record by another name or by position, as Ai=ax,E=out or Ai=#3; E=out[mA] also "
          "says the unit of a column whose header does not")
      ->allow_extra_args(false)
      ->type_name("NAME=COLUMN,...");
  verb.add_option("--encoding", flags.encoding,
                  "Encoding of the record, as UTF-8, GB18030 or Windows-1252 (default: detected)")
      ->type_name("NAME")
      ->take_last();
  add_choice(verb, "--decimal", kDecimalWords, flags.decimal,
             "The mark before the decimals of the record's numbers");
  add_choice(verb, "--overload", kOverloadWords, flags.overload,
             "What to do about rows in which a meter marked a value beyond its range");
}

ReadOptions read_options(const RecordFlags& flags, const CommonFlags& common) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  return {.rename = renames(flags.map),
          .encoding = flags.encoding,
          .decimal = flags.decimal,
          .overload = flags.overload,
          .threads = common.threads == 0 ? cores : common.threads};
}

RecordFlags flags_of(const Provenance& provenance) {
  RecordFlags flags;
  flags.path = provenance.input;
  for (const auto& [option, value] : provenance.options) {
    if (option == "map" && !value.empty()) flags.map = {value};
    if (option == "encoding" && value != "auto") flags.encoding = value;
    if (option == "decimal") {
      for (const auto& word : kDecimalWords)
        if (word.text == value) flags.decimal = word.value;
    }
    if (option == "overload") {
      for (const auto& word : kOverloadWords)
        if (word.text == value) flags.overload = word.value;
    }
  }
  return flags;
}

void add_given(Provenance& provenance, const RecordFlags& flags) {
  std::string map;
  for (const auto& [column, name] : renames(flags.map)) {
    map += fmt::format("{}{}={}", map.empty() ? "" : ",", column, name);
  }
  provenance.options.emplace_back("map", map);
  provenance.options.emplace_back("encoding", flags.encoding.empty() ? "auto" : flags.encoding);
  provenance.options.emplace_back("decimal", word_of(kDecimalWords, flags.decimal));
  provenance.options.emplace_back("overload", word_of(kOverloadWords, flags.overload));
}

}  // namespace proofmass::cli
