// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/misfit.hpp"

#include <string>
#include <utility>
#include <variant>

#include "proofmass/assess/diagnosis/fit/likely_reason.hpp"

namespace proofmass {
namespace {

constexpr double kGross = 0.9;
constexpr double kUnrelated = 0.1;

}  // namespace

std::optional<Finding> find_misfit(const FittedRows& rows, const Identification& result) {
  if (!result.train || !result.train->r2 || *result.train->r2 >= kGross) return std::nullopt;
  const double r2 = *result.train->r2;
  std::string reason = likely_reason(rows, 1.0 - kGross);
  // Robust does not follow them, and lists them.
  if (reason == "rows" && std::holds_alternative<RobustDetails>(result.details)) return std::nullopt;
  if (reason.empty()) reason = r2 < kUnrelated ? "unrelated" : "unknown";
  return Finding{.code = Code::gross_misfit,
                 .severity = Severity::warning,
                 .figures = {{"r2", r2}, {"limit", kGross}, {"reason", std::move(reason)}}};
}

}  // namespace proofmass
