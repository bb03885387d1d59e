// SPDX-License-Identifier: Apache-2.0
// Reference data are read from their folder and are never part of the project. A test must therefore be able
// to run without them:
//   const auto path = reference_data("nist/linear/Norris.dat");
//   if (!path) GTEST_SKIP() << kNoReferenceData;
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace proofmass::test {

inline constexpr const char* kNoReferenceData = "no reference data at " PROOFMASS_REFERENCE_DATA;

// Path of a reference file or folder; empty when it is absent.
[[nodiscard]] inline std::optional<std::filesystem::path> reference_data(std::string_view relative) {
  std::filesystem::path path = std::filesystem::path(PROOFMASS_REFERENCE_DATA) / relative;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path;
}

}  // namespace proofmass::test
