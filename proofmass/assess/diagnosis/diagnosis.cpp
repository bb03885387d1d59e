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
#include "proofmass/assess/diagnosis/fit/input_structure.hpp"
#include "proofmass/assess/diagnosis/fit/misfit.hpp"
#include "proofmass/assess/diagnosis/fit/mount_effects.hpp"
#include "proofmass/assess/diagnosis/fit/residual_effect.hpp"
#include "proofmass/assess/diagnosis/fit/residual_jump.hpp"
#include "proofmass/assess/diagnosis/fit/residual_trend.hpp"
#include "proofmass/assess/diagnosis/fit/scale_factor.hpp"
#include "proofmass/assess/diagnosis/fit/serial_correlation.hpp"
#include "proofmass/assess/diagnosis/fit/short_model.hpp"
#include "proofmass/assess/diagnosis/fit/unlike_rows.hpp"
#include "proofmass/assess/diagnosis/record/duplicated_rows.hpp"
#include "proofmass/assess/diagnosis/record/implausible_inputs.hpp"
#include "proofmass/assess/diagnosis/record/implausible_outputs.hpp"
#include "proofmass/assess/diagnosis/record/misread_columns.hpp"
#include "proofmass/assess/diagnosis/record/output_limits.hpp"
#include "proofmass/assess/diagnosis/record/time_order.hpp"
#include "proofmass/assess/diagnosis/record/wrapped_output.hpp"
#include "proofmass/assess/diagnosis/units/input_unit.hpp"
#include "proofmass/assess/diagnosis/units/mixed_units.hpp"

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

void add(Findings& findings, std::vector<ResidualEffect> effects) {
  for (ResidualEffect& effect : effects) findings.push_back(std::move(effect.finding));
}

// Structure along the inputs where terms should explain it, and the inputs are exact: the error of an input
// that is uncertain is part of it, and of its row's residual.
std::vector<FindEffect> effects_to_seek(const FittedRows& rows, const Identification& result) {
  std::vector<FindEffect> sought{find_residual_trend, find_mount_effect, find_residual_jump};
  if (rows.inputs_uncertain()) return sought;
  sought.push_back(find_hysteresis);
  if (takes_terms_as_given(result)) sought.push_back(find_input_structure);
  return sought;
}

bool is_jump(const ResidualEffect& effect) {
  const auto& figures = effect.finding.figures;
  return !figures.empty() && figures.front().name == "course" &&
         figures.front() != Figure("course", std::string("gradual")) &&
         figures.front() != Figure("course", std::string("factor_gradual"));
}

// Whether the missing terms are those that a change from one row on looks like: with it taken off no terms
// are missing, with the terms it is still there, and nothing else explains it.
bool is_made_by_jump(const FittedRows& rows, const Identification& result, const ShortModel& missing,
                     const std::vector<FindEffect>& sought) {
  const auto jump = find_residual_jump(rows);
  if (!jump || find_short_model(rows.with_columns(jump->columns), result) ||
      !find_residual_jump(rows.with_columns(missing.columns)))
    return false;
  const std::vector<ResidualEffect> effects = find_effects(rows, sought);
  return std::any_of(effects.begin(), effects.end(), is_jump);
}

// What the residuals follow, and whether there is anything. One cause shows in several
// ways: the first that is found is named, and the others are sought in what it leaves.
bool add_residual_findings(Findings& findings, const FittedRows& rows, const Identification& result) {
  if (!rows.has_noise()) return false;
  const std::vector<FindEffect> sought = effects_to_seek(rows, result);
  auto missing = find_short_model(rows, result);
  if (missing && !is_made_by_jump(rows, result, *missing, sought)) {
    findings.push_back(std::move(missing->finding));
    const FittedRows left = rows.with_columns(missing->columns);
    if (left.has_noise()) add(findings, find_effects(left, sought));
    return true;
  }
  std::vector<ResidualEffect> effects = find_effects(rows, sought);
  const bool alone = effects.empty();
  bool any = add(findings, alone ? find_far_rows(rows, result, true)
                                 : find_far_rows(without_effects(rows, effects), result, false));
  if (alone && !any) any = add(findings, find_serial_correlation(rows));
  add(findings, std::move(effects));
  return any || !alone;
}

bool has(std::span<const Finding> findings, Code code) {
  return std::any_of(findings.begin(), findings.end(), [code](const Finding& f) { return f.code == code; });
}

// Of the rows those whose lines are not among these.
std::vector<std::size_t> rows_beside(const Dataset& record, std::span<const std::size_t> rows,
                                     std::vector<std::size_t> lines) {
  std::sort(lines.begin(), lines.end());
  std::vector<std::size_t> others;
  for (const std::size_t row : rows) {
    if (!std::binary_search(lines.begin(), lines.end(), record.line_of(row))) others.push_back(row);
  }
  return others;
}

// Whether what was found in the record makes its coefficients and residuals wrong: what they look like then
// is a consequence.
bool is_explained(std::span<const Finding> of_record) {
  constexpr std::array kCauses{
      Code::inputs_in_other_unit, Code::input_far_off,          Code::inputs_are_angles,
      Code::rows_shifted,         Code::output_unsigned,        Code::output_copies_input,
      Code::output_clipped,       Code::output_saturated,       Code::output_held,
      Code::output_stuck,         Code::output_repeated,        Code::output_wrapped,
      Code::output_far_off,       Code::magnitude_unlike_others};
  return std::any_of(kCauses.begin(), kCauses.end(), [&](Code code) { return has(of_record, code); });
}

// Rows at a limit have one output without having been pasted twice.
bool has_limited_output(std::span<const Finding> of_record) {
  constexpr std::array kLimits{Code::output_clipped, Code::output_saturated, Code::output_held,
                               Code::output_stuck, Code::output_repeated};
  return std::any_of(kLimits.begin(), kLimits.end(), [&](Code code) { return has(of_record, code); });
}

// The others, each with its line.
Dataset without_rows(const Dataset& record, const std::vector<std::size_t>& rows) {
  std::vector<std::size_t> others;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    if (!std::binary_search(rows.begin(), rows.end(), row)) others.push_back(row);
  }
  Dataset part = record.select(others);
  part.line = record.lines_of(others);
  return part;
}

// What a method goes by in place of the record's columns: which terms it hides, and what it adds to the
// residuals, follow from it.
Dataset with_input_sigma(Dataset record, double sigma) {
  for (const Axis axis : record.axes()) {
    std::vector<double>& column = record.acceleration_sigma[static_cast<std::size_t>(axis)];
    column.assign(sigma > 0.0 ? record.rows() : 0, sigma);
  }
  return record;
}

}  // namespace

std::vector<Finding> diagnose_record(const Dataset& record) {
  Findings findings;
  add(findings, find_other_input_unit(record));
  add(findings, find_too_large_inputs(record));
  bool far_input = false;
  const UnlikeRows unlike = rows_of_unlike_magnitude(record);
  if (!unlike.rows.empty()) {
    findings.push_back(unlike_magnitude(record, unlike));
  } else {
    far_input = add(findings, find_far_input(record));
  }
  add(findings, find_implausible_temperature(record));
  const Dataset plausible = unlike.rows.empty() ? Dataset() : without_rows(record, unlike.rows);
  const Dataset& judged = unlike.rows.empty() ? record : plausible;
  const bool far_output = add(findings, find_far_output(record));
  if (!far_input && !far_output && !add(findings, find_misread_column(judged)) &&
      rows_in_other_unit(judged).empty()) {
    add(findings, find_output_limits(judged));
    add(findings, find_wrapped_output(judged));
  }
  add(findings, find_far_sigma(record));
  if (!has_limited_output(findings)) add(findings, find_duplicated_rows(record));
  add(findings, find_time_disorder(record));
  return findings;
}

std::vector<Finding> diagnose_fit(const Dataset& record, std::span<const Finding> of_record,
                                  const Split& split, const Identification& result, const SigmaUse& sigmas) {
  Findings findings;
  add(findings, find_few_degrees_of_freedom(result));
  const Dataset with_constant = sigmas.constant ? with_input_sigma(record, *sigmas.constant) : Dataset();
  const Dataset& rows_source = sigmas.constant ? with_constant : record;
  FittedRows rows(rows_source, split.training, result, sigmas.inputs_uncertain);
  if (has(of_record, Code::temperature_implausible)) rows.leave_out_temperature();
  // Where rows weigh by a wrong sigma_E, the residuals of the others follow from it.
  const bool wrong_weights = has(of_record, Code::sigma_output_far_off) && !rows.weights().empty();
  bool explained = is_explained(of_record) || wrong_weights || add(findings, find_misfit(rows, result));
  if (!explained) {
    add(findings, find_implausible_scale_factor(rows, result));
    explained = has(findings, Code::square_larger) || add_residual_findings(findings, rows, result);
  }
  // Of rows far off the others can be judged.
  const auto far = std::find_if(findings.begin(), findings.end(),
                                [](const Finding& f) { return f.code == Code::rows_far_off; });
  std::optional<Finding> uneven;
  if (far != findings.end() && !has(of_record, Code::sigma_output_far_off)) {
    const std::vector<std::size_t> others = rows_beside(record, split.training, far->lines);
    uneven = find_uneven_sigma(FittedRows(rows_source, others, result, sigmas.inputs_uncertain), result);
  }
  if (!has(of_record, Code::sigma_output_far_off))
    add(findings, find_wrong_sigmas(rows, result, sigmas.input_columns || sigmas.constant, explained));
  add(findings, std::move(uneven));
  add(findings, find_unlike_rows(rows, record, split, result));
  return findings;
}

}  // namespace proofmass
