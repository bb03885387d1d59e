// SPDX-License-Identifier: Apache-2.0
// The options of methods by name: for flags, help, documents, provenance and other languages.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proofmass/identify/method.hpp"

namespace proofmass {

// One row of a table of options, as text.
struct OptionInfo {
  std::string_view name;    // "outlier-limit"
  std::string_view former;  // an earlier name, which is still understood; may be empty
  std::string help;         // one line
  std::string_view place;   // in the documentation
  std::string type;         // what stands for a value: "N", "X", "on|off", "N|search"
  std::string range;        // "at least 1"; empty for choices
  std::string_view unit;    // that values are written in; empty where they have none
  std::string value;        // of the table it was read from: the default, of a method in its defaults
};

[[nodiscard]] std::vector<OptionInfo> options_of(const Method& method);
[[nodiscard]] std::vector<OptionInfo> options_of(const IdentifyOptions& options);

// Whether the method has an option of that name, present or former.
[[nodiscard]] bool has_option(const Method& method, std::string_view name);

// Sets an option from text; false when there is none of that name. Throws a usage Error "NAME: found 'TEXT',
// expected …".
bool set_option(Method& method, std::string_view name, std::string_view text);
bool set_option(IdentifyOptions& options, std::string_view name, std::string_view text);

// Names of the methods that have the option, in their order.
[[nodiscard]] std::vector<std::string_view> methods_with(std::string_view option);

// An option as all methods that take it have it.
struct SharedOption {
  OptionInfo info;  // as the first of them has it
  std::vector<std::string_view> methods;
  std::string defaults;  // "50; hybrid: 30"
};

// Every option of every method, once, in the order of the methods and their tables.
[[nodiscard]] std::vector<SharedOption> shared_options();

// All that decides an identification beside the record, in a fixed order: as provenance records it.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> resolved_options(
    const Method& method, const IdentifyOptions& options);

}  // namespace proofmass
