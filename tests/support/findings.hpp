// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "proofmass/core/identification.hpp"

namespace proofmass::test {

[[nodiscard]] inline bool has(const Identification& result, Code code) {
  return std::any_of(result.findings.begin(), result.findings.end(),
                     [code](const Finding& finding) { return finding.code == code; });
}

// The first finding of a code; throws std::out_of_range when there is none.
[[nodiscard]] inline const Finding& finding_of(const Identification& result, Code code) {
  for (const Finding& finding : result.findings) {
    if (finding.code == code) return finding;
  }
  throw std::out_of_range("no finding " + std::string(to_string(code)));
}

// A figure of a finding: a number, or the word that it is.
[[nodiscard]] inline const std::variant<double, std::string>& figure_value(const Finding& finding,
                                                                           std::string_view name) {
  for (const Figure& figure : finding.figures) {
    if (figure.name == name) return figure.value;
  }
  throw std::out_of_range("no figure " + std::string(name));
}
[[nodiscard]] inline double number(const Finding& finding, std::string_view name) {
  return std::get<double>(figure_value(finding, name));
}
[[nodiscard]] inline std::string word(const Finding& finding, std::string_view name) {
  return std::get<std::string>(figure_value(finding, name));
}

}  // namespace proofmass::test
