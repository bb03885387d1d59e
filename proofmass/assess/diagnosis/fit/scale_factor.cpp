// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/scale_factor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace proofmass {
namespace {

constexpr double kFarFromUnity = 0.1;  // from one
constexpr double kNear = 0.02;         // to a ratio of units

// What Ki is when a quantity is in another unit than it is taken for, in g.
struct UnitRatio {
  double ratio;
  const char* hint;
};
constexpr std::array kRatios{
    UnitRatio{kStandardGravity, "output_si"}, UnitRatio{1.0 / kStandardGravity, "inputs_si"},
    UnitRatio{1e3, "output_milli"},           UnitRatio{1e-3, "inputs_milli"},
    UnitRatio{1e6, "output_micro"},           UnitRatio{1e3 * kStandardGravity, "output_milli_si"}};

std::string hint_of(double size, bool declared) {
  for (const auto& [ratio, hint] : kRatios) {
    if (std::abs(size / ratio - 1.0) < kNear) return hint;
  }
  return declared ? "declared" : "undeclared";
}

std::optional<double> value_of(const Identification& result, Term term) {
  const auto at = std::find_if(result.coefficients.begin(), result.coefficients.end(),
                               [term](const Coefficient& c) { return c.term == term && c.identified; });
  return at == result.coefficients.end() ? std::nullopt : std::optional(at->value);
}

}  // namespace

std::vector<Finding> find_implausible_scale_factor(const Dataset& record, const Identification& result) {
  std::vector<Finding> findings;
  const auto ki = value_of(result, Term::Ki);
  if (!ki) return findings;
  const Unit& unit = record.output_unit;
  const std::string symbol = unit.canonical_symbol() + "/g";
  for (const Term cross : {Term::Ko, Term::Kp}) {
    const auto value = value_of(result, cross);
    if (!value || std::abs(*value) <= std::abs(*ki)) continue;
    findings.push_back({.code = Code::cross_axis_larger,
                        .severity = Severity::warning,
                        .terms = {cross},
                        .figures = {{"value", *value}, {"ki", *ki}, {"unit", symbol}}});
  }
  if (!findings.empty()) return findings;  // whatever Ki is then, it is not the scale factor
  if (*ki < 0.0) {
    findings.push_back({.code = Code::scale_factor_negative,
                        .severity = Severity::warning,
                        .terms = {Term::Ki},
                        .figures = {{"value", *ki}, {"unit", symbol}}});
  }
  if (unit.is_acceleration() && std::abs(std::abs(*ki) - 1.0) > kFarFromUnity) {
    findings.push_back(
        {.code = Code::scale_factor_unlike_one,
         .severity = Severity::warning,
         .terms = {Term::Ki},
         .figures = {{"value", *ki}, {"hint", hint_of(std::abs(*ki), record.output_unit_declared)}}});
  }
  return findings;
}

}  // namespace proofmass
