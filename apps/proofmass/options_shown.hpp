// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace proofmass::cli {

// An option as help, completion and manual pages show it.
struct ShownOption {
  std::string name;                  // "--method"
  std::string type;                  // what stands for a value: "N", "on|off"; empty for a flag
  std::string help;                  // may have several lines
  std::string group;                 // "Options", "Options of wls"
  std::vector<std::string> choices;  // of its value; empty where that is no choice
};

// Those of a verb in its order, without earlier names that are still understood.
[[nodiscard]] std::vector<ShownOption> options_shown(const CLI::App& verb);

}  // namespace proofmass::cli
