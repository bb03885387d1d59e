// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/identify/model/options.hpp"
#include "proofmass/pipeline.hpp"

namespace proofmass::cli {

// All that decides an identification, besides the record.
struct IdentifySettings {
  std::string method = "ols";
  std::string model = "paper";  // a preset, or the names of --terms
  std::string preset = "default";
  std::string initial_swarm = "none";  // the file it was read from
  IdentifyOptions options;
  SplitOptions split;
};

// The settings that the user asked for: those of the preset, changed by the flags given, in any order on the
// line.
class IdentifyFlags {
 public:
  // Whether the verb takes --method, or names its methods otherwise.
  enum class Method { option, given_elsewhere };
  // Adds the options to the verb; the object must outlive parsing.
  void add_to(CLI::App& verb, Method method = Method::option);
  // Throws a usage Error on unknown terms, or an impossible combination.
  [[nodiscard]] IdentifySettings settings() const;

 private:
  using Change = std::function<void(IdentifySettings&)>;
  void add_method_option(CLI::App& verb);
  void add_data_options(CLI::App& verb);
  void add_weight_options(CLI::App& verb);
  void add_uncertainty_options(CLI::App& verb);
  void add_gmdh_options(CLI::App& verb);
  void add_hidden_options(CLI::App& verb);
  void add_network_options(CLI::App& verb);
  void add_damping_options(CLI::App& verb);
  void add_swarm_options(CLI::App& verb);
  void add_swarm_endings(CLI::App& verb);
  void add_fish_options(CLI::App& verb);
  void add_fish_form(CLI::App& verb);

  template <typename Set>
  void real(CLI::App& verb, const std::string& option, double low, double high, const std::string& help,
            Set set);
  template <typename Set>
  void whole(CLI::App& verb, const std::string& option, std::uint64_t low, std::uint64_t high,
             const std::string& help, Set set);
  template <typename Words, typename Set>
  void choice(CLI::App& verb, const std::string& option, const Words& words, const std::string& help,
              Set set);

  std::string preset_ = "default";
  std::vector<Change> changes_;
};

// Every setting as provenance records it, in a fixed order. The number of threads is not among them: it
// changes nothing.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> describe(const IdentifySettings& settings);

}  // namespace proofmass::cli
