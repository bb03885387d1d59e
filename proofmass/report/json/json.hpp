// SPDX-License-Identifier: Apache-2.0
// Results as JSON, schema "proofmass.identification/1" of docs/file-formats.md.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "proofmass/core/run.hpp"

namespace proofmass {

// Numbers are written so that they read back to the same bits. What is absent is left out, and so are figures
// that are not finite (the condition number of a singular matrix); null stands only for such a value inside a
// history curve.
[[nodiscard]] std::string to_json(const Run& run);

// The reverse. `source` names the text in errors. Throws a bad-data Error that names
// the key which is missing, has the wrong type or contradicts another, or the schema that is unknown. Keys
// that the schema does not know are ignored.
[[nodiscard]] Run parse_result(std::string_view text, const std::string& source);

// parse_result of a file; "-" reads standard input.
[[nodiscard]] Run read_result(const std::filesystem::path& path);

}  // namespace proofmass
