// SPDX-License-Identifier: Apache-2.0
// Base class for tests of the command line, with a temporary folder. Needs PROOFMASS_CLI, the path of the
// program.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/process.hpp"
#include "support/temporary_folder.hpp"

namespace proofmass::test {

class CommandLine : public ::testing::Test {
 protected:
  using Json = nlohmann::ordered_json;

  [[nodiscard]] static Launch launch(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), PROOFMASS_CLI);
    return {.command = std::move(arguments)};
  }
  static Outcome proofmass(std::vector<std::string> arguments, std::string standard_input = {}) {
    Launch program = launch(std::move(arguments));
    program.standard_input = std::move(standard_input);
    return run_process(std::move(program));
  }
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string write(const std::string& name, std::string_view content) const {
    return folder_.write(name, content).string();
  }
  [[nodiscard]] std::string read(const std::string& name) const { return read_file(folder_.path() / name); }
  [[nodiscard]] Json read_json(const std::string& name) const { return Json::parse(read(name)); }
  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(at(name)); }
  [[nodiscard]] std::vector<std::string> names() const { return folder_.names(); }

  // A simulated record of the shipped twin.
  std::string make_record(const std::string& rows = "300", const std::string& sigma_ug = "10") const {
    const Outcome made = proofmass({"simulate", PROOFMASS_SOURCE_DIR "/data/twin.toml", "--rows", rows,
                                    "--sigma-ug", sigma_ug, "--out", at("run.csv")});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    return at("run.csv");
  }

  // The cells of a file that Proofmass wrote: commas, no quotes, no comments.
  [[nodiscard]] static std::vector<std::vector<std::string>> cells(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      rows.emplace_back();
      for (std::string word; std::getline(words, word, ',');) rows.back().push_back(word);
    }
    return rows;
  }

 private:
  TemporaryFolder folder_;
};

// Checks a failure: one line that contains all of these, and nothing on standard output.
inline void expect_failure(const Outcome& outcome, int exit_code, const std::vector<std::string>& parts) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.starts_with("proofmass: error: ")) << outcome.err;
  for (const std::string& part : parts) {
    EXPECT_NE(outcome.err.find(part), std::string::npos) << "no '" << part << "' in: " << outcome.err;
  }
}

}  // namespace proofmass::test
