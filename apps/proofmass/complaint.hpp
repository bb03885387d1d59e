// SPDX-License-Identifier: Apache-2.0
// Errors as the program says them, in the language of the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

#include "proofmass/core/error.hpp"
#include "proofmass/report/text/language.hpp"

namespace proofmass::cli {

// That --lang asks for, as far as can be told before the words are parsed: they may be wrong.
[[nodiscard]] Language language_of(std::span<const std::string> words);

// Why, what led to it, and what a user can do about it, as flags: "try: --split 1 or --terms K0,Ki,...".
[[nodiscard]] std::string complaint(const Error& error, Language language);

// To standard error, which may be closed or full; the exit code then has to say it all.
void complain(const std::string& text) noexcept;

// What CLI11 says of words that it cannot parse, with the option that an unknown one looks like and the page
// of help that lists them.
[[nodiscard]] Error misused(const CLI::ParseError& error, const CLI::App& app,
                            std::span<const std::string> words);

}  // namespace proofmass::cli
