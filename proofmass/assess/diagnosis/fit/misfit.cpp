// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/misfit.hpp"

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "proofmass/assess/diagnosis/fit/far_rows.hpp"
#include "proofmass/assess/diagnosis/fit/likely_reason.hpp"
#include "proofmass/assess/diagnosis/units/mixed_units.hpp"

namespace proofmass {
namespace {

constexpr double kGross = 0.9;
constexpr double kExact = 0.9999;  // of R², above which no unit is mixed
constexpr double kUnrelated = 0.1;

Finding misfit(double r2, std::string reason, const std::vector<std::size_t>& lines) {
  // Before the reason, whose words name the lines.
  return {.code = Code::gross_misfit,
          .severity = Severity::warning,
          .lines = lines,
          .figures = {{"r2", r2},
                      {"limit", kGross},
                      {"count", lines.size()},
                      {"named", std::string(lines.empty() ? "" : "lines")},
                      {"reason", std::move(reason)}}};
}

}  // namespace

std::optional<Finding> find_misfit(const FittedRows& rows, const Identification& result) {
  if (!result.train || !result.train->r2) return std::nullopt;
  const double r2 = *result.train->r2;
  // Rows with large inputs make R² large, whatever the unit of the others.
  const std::vector<std::size_t> mixed =
      r2 < kExact ? rows_in_other_unit(rows.record()) : std::vector<std::size_t>();
  if (!mixed.empty()) return misfit(r2, "mixed", rows.record().lines_of(mixed));
  if (r2 >= kGross) return std::nullopt;
  std::string reason = likely_reason(rows, 1.0 - kGross);
  if (reason.empty()) reason = r2 < kUnrelated ? "unrelated" : "unknown";
  if (reason != "rows") return misfit(r2, std::move(reason), {});
  // Robust does not follow them, and lists them.
  if (std::holds_alternative<RobustDetails>(result.details)) return std::nullopt;
  const auto far = find_far_rows(rows, result, true);
  return misfit(r2, std::move(reason), far ? far->lines : std::vector<std::size_t>());
}

}  // namespace proofmass
