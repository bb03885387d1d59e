// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace proofmass::cli {

// What a verb does once the command line has been parsed.
using Action = std::function<void()>;

// Each adds its verb, with options, description and examples, and returns what the verb does.
[[nodiscard]] Action add_simulate(CLI::App& verb);
[[nodiscard]] Action add_identify(CLI::App& verb);
[[nodiscard]] Action add_predict(CLI::App& verb);
[[nodiscard]] Action add_compare(CLI::App& verb);
[[nodiscard]] Action add_reproduce(CLI::App& verb);
[[nodiscard]] Action add_inspect(CLI::App& verb);
[[nodiscard]] Action add_report(CLI::App& verb);
// Made from all verbs of the app that this one belongs to.
[[nodiscard]] Action add_completion(CLI::App& verb);
[[nodiscard]] Action add_manual(CLI::App& verb);
[[nodiscard]] Action add_help(CLI::App& verb);

}  // namespace proofmass::cli
