// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace proofmass {

// The bytes of a small text file; "-" reads standard input. Throws a bad-data Error that expects `what` ("a
// result file") when it cannot be read, is a directory, or holds more than `most` bytes (endless input ends
// there).
[[nodiscard]] std::string read_text_file(const std::filesystem::path& path, std::string_view what,
                                         std::size_t most);

}  // namespace proofmass
