// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace proofmass {

// Compact JSON laid out for people: objects, and arrays that hold objects or arrays, one entry a line,
// indented by two blanks; arrays of plain values on one line. `compact` must be valid JSON without white
// space between tokens.
[[nodiscard]] std::string json_layout(std::string_view compact);

}  // namespace proofmass
