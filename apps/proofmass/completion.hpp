// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

namespace proofmass::cli {

// A script that completes verbs, options and choices in bash, zsh or fish, made from the verbs of the app.
// Throws a usage Error on another shell.
[[nodiscard]] std::string completion_script(const CLI::App& app, std::string_view shell);

}  // namespace proofmass::cli
