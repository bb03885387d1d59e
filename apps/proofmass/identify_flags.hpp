// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/core/run.hpp"
#include "proofmass/identify/method.hpp"

namespace proofmass::cli {

// The flags that decide an identification. Those of the methods come from the methods' own tables of options.
class IdentifyFlags {
 public:
  // Whether the verb takes --method, or names its methods otherwise.
  enum class Naming { option, elsewhere };
  // Adds the flags to the verb; the object must outlive parsing.
  void add_to(CLI::App& verb, Naming naming = Naming::option);

  // What every method takes. Throws a usage Error on unknown terms or values that make no sense.
  [[nodiscard]] IdentifyOptions options() const;
  // The methods named, each with those of the flags given that it takes. Throws a usage Error when none of
  // them takes one of the flags, and on values that make no sense.
  [[nodiscard]] std::vector<Method> methods(std::span<const std::string> names) const;
  // That of --method.
  [[nodiscard]] Method method() const;
  // The preset, and the file of initial positions, where the method takes them: for provenance.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> more(const Method& method) const;

 private:
  void add_terms(CLI::App& verb);
  void add_common_options(CLI::App& verb);
  void add_method_options(CLI::App& verb);
  void add_whole_settings(CLI::App& verb);
  void add_given(CLI::App& verb, const std::string& name, const std::string& help, const std::string& type,
                 const std::string& group);
  // Throws a usage Error when another flag has chosen the terms.
  void take_terms_from(const std::string& flag, const std::string& text);
  // Throws a usage Error when an option is given by its present and its former name.
  void require_one_name() const;
  void require_taken(std::span<const Method> chosen) const;

  std::string method_;
  std::string model_;       // a preset of terms or their names; empty when not given
  std::string model_flag_;  // that it was given by: "model" or "terms"
  std::vector<std::pair<std::string, std::string>> given_;   // options of methods as name and text
  std::vector<std::pair<std::string, std::string>> common_;  // of all methods, likewise
};

// Adds to the provenance what the command line gave beside the options of the method.
void add_given(Provenance& provenance, const Method& method, const IdentifyFlags& flags);

}  // namespace proofmass::cli
