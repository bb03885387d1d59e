// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/ols.hpp"

#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/model/term_sums.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"

namespace proofmass {

Identification fit(const Ols& /*method*/, const Dataset& training, const IdentifyOptions& options,
                   Progress& progress) {
  progress.update("least squares", 0, 1);
  const TermSums sums(training, options.terms);
  const Identifiability found = require_identifiable(sums, options.on_rank_loss);
  if (progress.cancelled())
    throw Error(ErrorKind::interrupted, "interrupted before the least-squares solution");
  NormalSolution solution = solve_normal_equations(sums.gram(found.identified), sums.rows(found.identified));
  const double variance = solution.rss / static_cast<double>(solution.dof);
  const StaticFit fit{.coefficients = std::move(solution.coefficients),
                      .covariance = scaled(std::move(solution.unscaled_covariance), variance),
                      .vif = std::move(solution.vif)};

  Identification result = make_identification("ols", training, options, found, fit);
  add_residual_figures(result.diagnostics, training, solution.rss, found.identified.size());
  result.findings.push_back({.code = Code::white_noise_assumed});
  note_unused_sigma(result, training);
  result.ending = {.status = EndingStatus::direct,
                   .parts = {{.code = EndingCode::normal_equations,
                              .figures = {{"rows", training.rows()}, {"count", found.identified.size()}}}}};
  progress.update("least squares", 1, 1);
  return result;
}

}  // namespace proofmass
