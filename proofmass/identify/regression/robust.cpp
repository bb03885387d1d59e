// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/robust.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/design_matrix.hpp"
#include "proofmass/identify/model/ending_of.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/options/field_text.hpp"
#include "proofmass/identify/regression/weighted_rows.hpp"
#include "proofmass/numeric/regression/robust_regression.hpp"

namespace proofmass {
namespace {

// Mean slope of psi below which the loss is nearly flat over most rows.
constexpr double kLeastSlope = 0.05;

// Fits, and again without the terms that the rows with weight cannot identify.
RobustFit fit_identifiable(const Robust& method, const Dataset& training, const IdentifyOptions& options,
                           Identifiability& found, const Progress& progress) {
  while (true) {
    RobustFit fit =
        fit_robustly(design_matrix(training, found.identified), training.output,
                     {.loss = method.loss, .tuning = method.tuning, .iterations = method.iterations},
                     [&progress] { return !progress.cancelled(); });
    if (fit.termination.cause == Cause::stopped) {
      throw Error(ErrorKind::interrupted, "interrupted during the robust fit");
    }
    const std::size_t before = found.identified.size();
    found = require_identifiable_by_weight(training, found, fit.weights, options.on_rank_loss);
    if (found.identified.size() < before) continue;
    if (fit.rank_deficient) {
      throw refusal(
          message("{}: so many rows lost their weight that the rest hardly determine the terms; a loss "
                  "that keeps weight, or fewer terms, may do",
                  training.source),
          {{"loss", "huber"}, {"terms", ""}});
    }
    return fit;
  }
}

void require_curvature(const Dataset& training, const RobustFit& fit) {
  if (fit.psi_slope > kLeastSlope) return;
  throw refusal(
      message("{}: too many rows lie where the loss is flat (mean slope of psi {:.2g}) for a usable "
              "fit; a larger constant of the loss, or Huber's loss, may do",
              training.source, fit.psi_slope),
      {{"tuning", ""}, {"loss", "huber"}});
}

std::vector<SuspectRow> suspect_rows(const Dataset& training, const RobustFit& fit, double limit) {
  std::vector<SuspectRow> suspects;
  if (!(fit.scale > 0.0)) return suspects;
  for (std::size_t row = 0; row < fit.residuals.size(); ++row) {
    const double scaled = fit.residuals[row] / fit.scale;
    if (!(std::abs(scaled) > limit)) continue;
    SuspectRow suspect{.row = row + 1,
                       .line = std::nullopt,
                       .residual = fit.residuals[row],
                       .scaled_residual = scaled,
                       .weight = fit.weights[row]};
    if (!training.line.empty()) suspect.line = training.line[row];
    suspects.push_back(suspect);
  }
  std::stable_sort(suspects.begin(), suspects.end(), [](const SuspectRow& a, const SuspectRow& b) {
    return std::abs(a.scaled_residual) > std::abs(b.scaled_residual);
  });
  return suspects;
}

Finding loss_finding(const RobustFit& fit, bool given, const std::string& unit) {
  switch (fit.loss.kind) {
    case LossKind::huber:
      return {.code = Code::huber_loss, .figures = {{"tuning", fit.loss.tuning}}};
    case LossKind::bisquare:
      return {.code = Code::bisquare_loss, .figures = {{"tuning", fit.loss.tuning}}};
    case LossKind::student:
      return {.code = Code::student_loss,
              .figures = {{"tuning", fit.loss.tuning},
                          {"origin", std::string(given               ? "given"
                                                 : fit.scale_floored ? "default"
                                                                     : "estimated")},
                          {"scale", fit.loss_scale},
                          {"unit", unit}}};
  }
  return {};
}

// On the scale that decides which rows are suspect.
void add_scale_findings(std::vector<Finding>& findings, const RobustFit& fit, const std::string& unit) {
  if (fit.scale_floored && fit.resolution > 0.0) {
    findings.push_back(
        {.code = Code::scale_at_resolution,
         .figures = {{"step", fit.resolution}, {"rounding", fit.scale_floor}, {"unit", unit}}});
  } else if (fit.scale_floored) {
    findings.push_back(
        {.code = Code::scale_at_rounding, .figures = {{"scale", fit.scale_floor}, {"unit", unit}}});
  }
  const std::size_t spare = fit.residuals.size() - fit.coefficients.size();
  if (fit.scale_check.doubtful) {
    findings.push_back({.code = Code::scale_doubtful,
                        .severity = Severity::warning,
                        .figures = {{"over_shortest_half", fit.scale_check.over_shortest_half},
                                    {"quantile_ratio", fit.scale_check.quantile_ratio}}});
  } else if (spare < kEnoughSpareRows) {
    // Said of every short record, sound or not.
    findings.push_back({.code = Code::scale_doubtful,
                        .severity = Severity::basis,
                        .figures = {{"spare", spare}, {"enough", kEnoughSpareRows}}});
  }
}

void add_findings(Identification& result, const Dataset& training, const RobustFit& fit, const Robust& method,
                  const std::vector<SuspectRow>& suspects) {
  const std::string unit = training.output_unit.canonical_symbol();
  result.findings.push_back(loss_finding(fit, method.tuning.has_value(), unit));
  Finding outlying{.code = Code::outlying_rows,
                   .figures = {{"count", suspects.size()},
                               {"total", training.rows()},
                               {"limit", method.outlier_limit},
                               {"scale", fit.scale},
                               {"unit", unit}}};
  for (const SuspectRow& suspect : suspects) outlying.lines.push_back(suspect.line.value_or(suspect.row));
  result.findings.push_back(std::move(outlying));
  add_scale_findings(result.findings, fit, unit);
  result.findings.push_back({.code = Code::robust_errors_asymptotic});
  note_unused_sigma(result, training);
}

}  // namespace

Identification fit(const Robust& method, const Dataset& training, const IdentifyOptions& options,
                   Progress& progress) {
  require_in_range(method);
  progress.update("robust regression", 0, 1);
  Identifiability found = require_identifiable(training, options.terms, options.on_rank_loss);
  RobustFit fit = fit_identifiable(method, training, options, found, progress);
  require_curvature(training, fit);

  Identification result =
      make_identification("robust", training, options, found,
                          {.coefficients = fit.coefficients, .covariance = fit.covariance, .vif = fit.vif});
  add_residual_figures(result.diagnostics, training, fit.rss, found.identified.size());
  result.diagnostics.iterations = fit.iterations;
  std::vector<SuspectRow> suspects = suspect_rows(training, fit, method.outlier_limit);
  add_findings(result, training, fit, method, suspects);
  result.details = RobustDetails{.scale = fit.scale, .suspect_rows = std::move(suspects)};
  std::vector<double> slopes = fit.residuals;
  for (double& r : slopes) r = fit.loss_scale > 0.0 ? fit.loss.slope(r / fit.loss_scale) : 1.0;
  result.row_weights = {.values = std::move(fit.weights), .slopes = std::move(slopes), .fixed = false};
  result.ending = ending_of(fit.termination);
  progress.update("robust regression", 1, 1);
  return result;
}

}  // namespace proofmass
