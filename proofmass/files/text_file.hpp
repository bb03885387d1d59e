// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "proofmass/core/message.hpp"

namespace proofmass {

// What "-" is called where inputs are named.
inline constexpr std::string_view kStandardInput = "standard input";

// Reads all bytes of a small text file; "-" reads standard input. Throws a bad-data Error when the file
// cannot be read, is a directory, or holds more than `most` bytes (which also ends endless input). The Error
// states what was expected: `what`, such as "a result file".
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path, const Message& what,
                                         std::size_t most);

}  // namespace proofmass
