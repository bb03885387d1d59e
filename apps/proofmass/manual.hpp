// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

namespace proofmass::cli {

// The manual page, section 1, of the program or, when `verb` is not empty, of a verb, for man. Throws a usage
// Error on an unknown verb.
[[nodiscard]] std::string manual_page(const CLI::App& app, std::string_view verb);

}  // namespace proofmass::cli
