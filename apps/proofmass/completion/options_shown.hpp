// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

namespace proofmass::cli {

// What an option or an argument takes, as far as a shell can offer it.
enum class Takes : std::uint8_t {
  nothing,  // a flag
  text,     // a number, or what the program does not know beforehand
  one_of,   // the choices
  list_of,  // choices with commas between them
  file,
  folder,
};

// An option or an argument as help, completion and manual pages show it.
struct ShownOption {
  std::string name;   // "--method"; of an argument "RUN.csv"
  std::string type;   // what stands for a value: "N", "on|off"; empty for a flag
  std::string help;   // may have several lines
  std::string group;  // "Options", "Options of wls"
  Takes takes = Takes::nothing;
  std::vector<std::string> choices{};  // of one_of and list_of
};

// Those of a verb in its order, without earlier names that are still understood.
[[nodiscard]] std::vector<ShownOption> options_shown(const CLI::App& verb);
// What follows the verb without a name, in its order.
[[nodiscard]] std::vector<ShownOption> arguments_shown(const CLI::App& verb);

[[nodiscard]] std::vector<std::string> verb_names(const CLI::App& app);

// The first line of a text, without the colon that leads to others.
[[nodiscard]] std::string first_line(const std::string& text);

}  // namespace proofmass::cli
