// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/robust.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/design_matrix.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/regression/weighted_rows.hpp"
#include "proofmass/numeric/regression/robust_regression.hpp"

namespace proofmass {
namespace {

// Mean slope of psi below which the loss is nearly flat over most rows.
constexpr double kLeastSlope = 0.05;

// Fits, and again without the terms that are lost together with the rows' weights.
RobustFit fit_identifiable(const Dataset& training, const IdentifyOptions& options, Identifiability& found,
                           const Progress& progress) {
  while (true) {
    RobustFit fit = fit_robustly(design_matrix(training, found.identified), training.output,
                                 options.robust.fit, [&progress] { return !progress.cancelled(); });
    if (fit.termination.cause == Cause::stopped) {
      throw Error(ErrorKind::interrupted, "interrupted during the robust fit");
    }
    const std::size_t before = found.identified.size();
    found = require_identifiable_by_weight(training, found, fit.weights, options.on_rank_loss);
    if (found.identified.size() < before) continue;
    if (fit.rank_lost) {
      throw refusal(fmt::format(
          "{}: so many rows lost their weight that the rest hardly determine the terms; a loss that keeps "
          "weight (--loss huber), or fewer terms (--terms), may do",
          training.source));
    }
    return fit;
  }
}

void require_curvature(const Dataset& training, const RobustFit& fit) {
  if (fit.psi_slope > kLeastSlope) return;
  throw refusal(fmt::format(
      "{}: too many rows lie where the loss is flat (mean slope of psi {:.2g}) for a usable fit; a larger "
      "constant (--tuning) or --loss huber may do",
      training.source, fit.psi_slope));
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

std::string loss_note(const RobustFit& fit, bool given, const std::string& unit) {
  switch (fit.loss.kind) {
    case LossKind::huber:
      return fmt::format("Huber's loss with k = {:g}", fit.loss.tuning);
    case LossKind::bisquare:
      return fmt::format("Tukey's bisquare loss with c = {:g}", fit.loss.tuning);
    case LossKind::student:
      return fmt::format("likelihood of Student's t with {:.4g} degrees of freedom ({}) and scale {:.5g} {}",
                         fit.loss.tuning, given ? "given" : "estimated", fit.loss_scale, unit);
  }
  return {};
}

void add_notes(Diagnostics& diagnostics, const Dataset& training, const RobustFit& fit,
               const RobustSettings& settings) {
  const std::string unit = training.output_unit.canonical_symbol();
  diagnostics.notes.push_back(fmt::format(
      "{}; residuals have a robust scale (median of their sizes / 0.6745) of {:.5g} {}; {} of {} rows lie "
      "beyond {:g} of it",
      loss_note(fit, settings.fit.tuning.has_value(), unit), fit.scale, unit, diagnostics.suspect_rows.size(),
      training.rows(), settings.outlier_limit));
  diagnostics.notes.emplace_back(
      "standard errors are asymptotic (Huber 1981); they assume exact inputs and independent output noise "
      "with one symmetric distribution in every row; residual sd counts outliers in full");
  if (!training.output_sigma.empty()) {
    diagnostics.notes.emplace_back("sigma_E is not used: all rows share one scale, estimated from residuals");
  }
}

}  // namespace

Identification identify_robust(const Dataset& training, const Dataset& /*validation*/,
                               const IdentifyOptions& options, Progress& progress) {
  progress.update("robust regression", 0, 1);
  Identifiability found = require_identifiable(training, options.terms, options.on_rank_loss);
  RobustFit fit = fit_identifiable(training, options, found, progress);
  require_curvature(training, fit);

  Identification result =
      make_identification("robust", training, options, found,
                          {.coefficients = fit.coefficients, .covariance = fit.covariance, .vif = fit.vif});
  add_residual_figures(result.diagnostics, training, fit.rss, found.identified.size());
  result.diagnostics.iterations = fit.iterations;
  result.diagnostics.robust_scale = fit.scale;
  result.diagnostics.suspect_rows = suspect_rows(training, fit, options.robust.outlier_limit);
  add_notes(result.diagnostics, training, fit, options.robust);
  result.ending = {.status = fit.termination.cause == Cause::converged ? EndingStatus::converged
                                                                       : EndingStatus::iteration_limit,
                   .reason = std::move(fit.termination.reason)};
  progress.update("robust regression", 1, 1);
  return result;
}

}  // namespace proofmass
