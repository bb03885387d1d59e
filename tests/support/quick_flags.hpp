// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proofmass/identify/method_options.hpp"

namespace proofmass::test {

// Flags that make any method quick, and able to run on a record without sigma columns: of a list those that
// the method takes.
[[nodiscard]] inline std::vector<std::string> quick_flags(std::string_view method) {
  constexpr std::array kFlags{std::pair{"epochs", "30"},          std::pair{"particles", "6"},
                              std::pair{"iterations", "4"},       std::pair{"refine", "2"},
                              std::pair{"sigma-input-ug", "100"}, std::pair{"sigma-output-ug", "10"}};
  std::vector<std::string> flags;
  for (const auto& [name, value] : kFlags) {
    if (!has_option(find_method(method), name)) continue;
    flags.insert(flags.end(), {std::string("--") + name, value});
  }
  return flags;
}

}  // namespace proofmass::test
