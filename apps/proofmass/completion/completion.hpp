// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

namespace proofmass::cli {

// A script that completes verbs, options and their values in bash, zsh or fish, made from the verbs of the
// app. Throws a usage Error on another shell.
[[nodiscard]] std::string completion_script(const CLI::App& app, std::string_view shell);

[[nodiscard]] std::string bash_completion(const CLI::App& app);
[[nodiscard]] std::string zsh_completion(const CLI::App& app);
[[nodiscard]] std::string fish_completion(const CLI::App& app);

}  // namespace proofmass::cli
