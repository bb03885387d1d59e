// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace proofmass::cli {

// Help in lines of at most 80 columns, broken at words; what CLI11 would say of excluded and required options
// is left out.
class HelpText final : public CLI::Formatter {
 public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_subcommand(const CLI::App* verb) const override;
};

}  // namespace proofmass::cli
