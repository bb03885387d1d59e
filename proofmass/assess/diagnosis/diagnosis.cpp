// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/diagnosis.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "proofmass/assess/diagnosis/fit/chi_square.hpp"
#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/assess/diagnosis/fit/misfit.hpp"
#include "proofmass/assess/diagnosis/fit/mount_offsets.hpp"
#include "proofmass/assess/diagnosis/fit/residual_trend.hpp"
#include "proofmass/assess/diagnosis/fit/scale_factor.hpp"
#include "proofmass/assess/diagnosis/fit/serial_correlation.hpp"
#include "proofmass/assess/diagnosis/fit/short_model.hpp"
#include "proofmass/assess/diagnosis/fit/unlike_rows.hpp"
#include "proofmass/assess/diagnosis/record/duplicated_rows.hpp"
#include "proofmass/assess/diagnosis/record/input_unit.hpp"
#include "proofmass/assess/diagnosis/record/output_limits.hpp"
#include "proofmass/assess/diagnosis/record/time_order.hpp"
#include "proofmass/assess/diagnosis/record/wrapped_counts.hpp"

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

// What the residuals follow. One cause shows in several ways: the first that is found is named.
void add_residual_findings(Findings& findings, const FittedRows& rows, const Identification& result) {
  if (!rows.has_noise()) return;
  if (add(findings, find_short_model(rows, result))) return;
  const bool follows = add(findings, find_residual_trend(rows));
  if (!add(findings, find_mount_offsets(rows)) && !follows) add(findings, find_serial_correlation(rows));
}

}  // namespace

std::vector<Finding> diagnose_record(const Dataset& record) {
  Findings findings;
  add(findings, find_other_input_unit(record));
  add(findings, find_output_limits(record));
  add(findings, find_wrapped_counts(record));
  add(findings, find_duplicated_rows(record));
  add(findings, find_time_disorder(record));
  return findings;
}

std::vector<Finding> diagnose_fit(const Dataset& record, const Split& split, const Identification& result,
                                  bool inputs_sigma_used) {
  Findings findings;
  add(findings, find_implausible_scale_factor(record, result));
  add(findings, find_few_degrees_of_freedom(result));
  const FittedRows rows(record, split.training, result);
  if (!add(findings, find_misfit(rows, result))) add_residual_findings(findings, rows, result);
  add(findings, find_wrong_sigmas(rows, result, inputs_sigma_used));
  add(findings, find_unlike_rows(rows, record, split, result));
  return findings;
}

}  // namespace proofmass
