// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/diagnosis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "proofmass/assess/diagnosis/fit/chi_square.hpp"
#include "proofmass/assess/diagnosis/fit/far_rows.hpp"
#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/assess/diagnosis/fit/misfit.hpp"
#include "proofmass/assess/diagnosis/fit/mount_effects.hpp"
#include "proofmass/assess/diagnosis/fit/residual_trend.hpp"
#include "proofmass/assess/diagnosis/fit/scale_factor.hpp"
#include "proofmass/assess/diagnosis/fit/serial_correlation.hpp"
#include "proofmass/assess/diagnosis/fit/short_model.hpp"
#include "proofmass/assess/diagnosis/fit/unlike_rows.hpp"
#include "proofmass/assess/diagnosis/record/duplicated_rows.hpp"
#include "proofmass/assess/diagnosis/record/input_unit.hpp"
#include "proofmass/assess/diagnosis/record/output_limits.hpp"
#include "proofmass/assess/diagnosis/record/time_order.hpp"
#include "proofmass/assess/diagnosis/record/wrapped_output.hpp"

namespace proofmass {
namespace {

using Findings = std::vector<Finding>;

bool add(Findings& findings, std::optional<Finding> found) {
  if (!found) return false;
  findings.push_back(std::move(*found));
  return true;
}

bool add(Findings& findings, Findings found) {
  findings.insert(findings.end(), found.begin(), found.end());
  return !found.empty();
}

// Standard errors from so few are themselves uncertain by a third and more.
std::optional<Finding> find_few_degrees_of_freedom(const Identification& result) {
  constexpr std::size_t kHandful = 5;
  const auto dof = result.diagnostics.dof;
  if (!dof || *dof == 0 || *dof >= kHandful) return std::nullopt;
  return Finding{.code = Code::few_degrees_of_freedom,
                 .severity = Severity::warning,
                 .figures = {{"dof", *dof},
                             {"rows", result.train ? result.train->n : 0},
                             {"percent", 100.0 / std::sqrt(2.0 * static_cast<double>(*dof))}}};
}

// Mounts in sequence make a trend, and a trend makes mounts differ: what the other explains is not named.
bool add_trend_or_mounts(Findings& findings, const FittedRows& rows) {
  auto trend = find_residual_trend(rows);
  auto mounts = find_mount_effect(rows);
  if (trend && mounts && mounts->columns.columns() > 0) {
    const bool trend_stays = find_residual_trend(rows.with_columns(mounts->columns)).has_value();
    const bool mounts_stay = find_mount_effect(rows.with_columns(trend->columns)).has_value();
    const bool both = trend_stays && mounts_stay;
    const bool trend_first = trend_stays == mounts_stay ? trend->errors > mounts->errors : trend_stays;
    if (!both && trend_first) mounts.reset();
    if (!both && !trend_first) trend.reset();
  }
  if (trend) findings.push_back(std::move(trend->finding));
  if (mounts) findings.push_back(std::move(mounts->finding));
  return trend || mounts;
}

// What the residuals follow. One cause shows in several ways: the first that is found is named, and the
// others are sought in what it leaves.
void add_residual_findings(Findings& findings, const FittedRows& rows, const Identification& result) {
  if (!rows.has_noise()) return;
  if (auto missing = find_short_model(rows, result)) {
    findings.push_back(std::move(missing->finding));
    const FittedRows left = rows.with_columns(missing->columns);
    if (left.has_noise()) add_trend_or_mounts(findings, left);
    return;
  }
  add(findings, find_far_rows(rows, result));
  if (!add_trend_or_mounts(findings, rows)) add(findings, find_serial_correlation(rows));
}

// Whether what was found in the record makes its coefficients and residuals wrong: what they look like then
// is a consequence.
bool is_explained(std::span<const Finding> of_record) {
  constexpr std::array kCauses{Code::inputs_in_other_unit, Code::output_clipped, Code::output_saturated,
                               Code::output_held,          Code::output_stuck,   Code::output_repeated,
                               Code::output_wrapped};
  return std::any_of(of_record.begin(), of_record.end(), [&](const Finding& finding) {
    return std::find(kCauses.begin(), kCauses.end(), finding.code) != kCauses.end();
  });
}

}  // namespace

std::vector<Finding> diagnose_record(const Dataset& record) {
  Findings findings;
  add(findings, find_other_input_unit(record));
  add(findings, find_output_limits(record));
  add(findings, find_wrapped_output(record));
  add(findings, find_duplicated_rows(record));
  add(findings, find_time_disorder(record));
  return findings;
}

std::vector<Finding> diagnose_fit(const Dataset& record, std::span<const Finding> of_record,
                                  const Split& split, const Identification& result, bool inputs_sigma_used) {
  Findings findings;
  add(findings, find_few_degrees_of_freedom(result));
  const FittedRows rows(record, split.training, result);
  if (!is_explained(of_record) && !add(findings, find_misfit(rows, result))) {
    add(findings, find_implausible_scale_factor(rows, result));
    add_residual_findings(findings, rows, result);
  }
  add(findings, find_wrong_sigmas(rows, result, inputs_sigma_used));
  add(findings, find_unlike_rows(rows, record, split, result));
  return findings;
}

}  // namespace proofmass
