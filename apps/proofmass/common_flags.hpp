// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "proofmass/identify/options/field.hpp"
#include "proofmass/report/text/language.hpp"

namespace proofmass::cli {

struct CommonFlags {
  bool quiet = false;
  std::size_t threads = 0;           // 0: one for every core
  bool wide = false;                 // tables as wide as they are
  Language language = Language::en;  // of tables and of what was found
};

void add_common(CLI::App& verb, CommonFlags& flags);
// For verbs that print tables.
void add_wide(CLI::App& verb, CommonFlags& flags);
// For verbs that say what was found.
void add_language(CLI::App& verb, CommonFlags& flags);
// An option that names a file or folder: its name must not be empty.
CLI::Option* add_path(CLI::App& verb, const std::string& option, std::string& path, const std::string& help);
void add_json(CLI::App& verb, std::string& path);
void add_report_file(CLI::App& verb, std::string& path);

// The date here, as 2026-11-28; by SOURCE_DATE_EPOCH, in UTC, where that is set.
[[nodiscard]] std::string today();

// Adds an option whose number goes to `set` when the user gives it.
void add_real(CLI::App& verb, const std::string& option, const Range<double>& range, const std::string& help,
              std::function<void(double)> set);
void add_whole(CLI::App& verb, const std::string& option, std::uint64_t low, std::uint64_t high,
               const std::string& help, std::function<void(std::uint64_t)> set);

}  // namespace proofmass::cli
