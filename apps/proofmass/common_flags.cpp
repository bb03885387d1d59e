// SPDX-License-Identifier: Apache-2.0
#include "common_flags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/options/field_text.hpp"

namespace proofmass::cli {
namespace {

constexpr std::uint64_t kMostThreads = 1024;
constexpr std::array kLanguageWords{Word<Language>{"en", Language::en}, Word<Language>{"zh", Language::zh}};

}  // namespace

void add_real(CLI::App& verb, const std::string& option, const Range<double>& range, const std::string& help,
              std::function<void(double)> set) {
  const auto take = [option, range, set = std::move(set)](const std::string& text) {
    set(read_number(option, text, range));
  };
  verb.add_option_function<std::string>(option, take, help)->type_name("X");
}

void add_whole(CLI::App& verb, const std::string& option, std::uint64_t low, std::uint64_t high,
               const std::string& help, std::function<void(std::uint64_t)> set) {
  const auto take = [option, range = whole(low, high), set = std::move(set)](const std::string& text) {
    set(read_number(option, text, range));
  };
  verb.add_option_function<std::string>(option, take, help)->type_name("N");
}

void add_common(CLI::App& verb, CommonFlags& flags) {
  verb.add_flag("--quiet", flags.quiet, "No progress on standard error");
  add_whole(verb, "--threads", 0, kMostThreads, "At most N threads; 0, the default, is one for every core",
            [&flags](std::uint64_t n) { flags.threads = n; });
}

void add_wide(CLI::App& verb, CommonFlags& flags) {
  verb.add_flag("--wide", flags.wide, "Tables with all their columns, however wide the terminal is");
}

void add_language(CLI::App& verb, CommonFlags& flags) {
  const auto take = [&flags](const std::string& text) {
    const auto* const word = std::find_if(kLanguageWords.begin(), kLanguageWords.end(),
                                          [&text](const Word<Language>& one) { return one.text == text; });
    if (word == kLanguageWords.end()) {
      throw not_one_of("--lang", text, list_of(kLanguageWords));
    }
    flags.language = word->value;
  };
  verb.add_option_function<std::string>(
          "--lang", take,
          "Language of tables, findings and errors: English or Chinese (default "
          "en); reports open in it; other files and this help are in English")
      ->type_name(list_of(kLanguageWords, "|"))
      ->take_last();
}

CLI::Option* add_path(CLI::App& verb, const std::string& option, std::string& path, const std::string& help) {
  const auto take = [option, &path](const std::string& text) {
    if (text.empty())
      throw usage_error(message("{}: found an empty name, expected a file or folder", option));
    if (text.starts_with("--")) {
      throw usage_error(message("{}: found '{}', expected a file or folder; ./{} is one of that name", option,
                                excerpt(text), excerpt(text)));
    }
    path = text;
  };
  return verb.add_option_function<std::string>(option, take, help);
}

void add_json(CLI::App& verb, std::string& path) {
  add_path(verb, "--json", path,
           "Write the result as JSON to FILE; - is standard output, in place of the table")
      ->type_name("FILE");
}

void add_report_file(CLI::App& verb, std::string& path) {
  add_path(verb, "--report", path,
           "Write a report with figures to FILE, one HTML page that opens from disk; - is standard output")
      ->type_name("FILE");
}

std::string today() {
  std::tm date{};
  const char* const fixed = std::getenv("SOURCE_DATE_EPOCH");  // reproducible-builds.org
  std::time_t seconds = 0;
  const std::string_view text = fixed == nullptr ? std::string_view() : fixed;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), seconds);
  const bool is_fixed = !text.empty() && read.ec == std::errc() && read.ptr == text.data() + text.size();
  if (!is_fixed) seconds = std::time(nullptr);
  constexpr int kFirstYear = 1900, kLastYear = 9999;
  const std::tm* const made = is_fixed ? gmtime_r(&seconds, &date) : localtime_r(&seconds, &date);
  if (made == nullptr || date.tm_year + kFirstYear > kLastYear) return {};
  return fmt::format("{:04}-{:02}-{:02}", date.tm_year + kFirstYear, date.tm_mon + 1, date.tm_mday);
}

}  // namespace proofmass::cli
