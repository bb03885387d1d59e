// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/ols.hpp"

#include <fmt/format.h>

#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/model/term_sums.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"

namespace proofmass {
namespace {

Matrix scaled(Matrix matrix, double factor) {
  for (std::size_t c = 0; c < matrix.columns(); ++c) {
    for (double& value : matrix.column(c)) value *= factor;
  }
  return matrix;
}

}  // namespace

Identification identify_ols(const Dataset& training, const Dataset& /*validation*/,
                            const IdentifyOptions& options, Progress& progress) {
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
  result.diagnostics.notes.emplace_back(
      "standard errors assume exact inputs and output noise that is white with the same variance in every "
      "row");
  if (!training.output_sigma.empty()) {
    result.diagnostics.notes.emplace_back(
        "sigma_E is not used: ordinary least squares weighs all rows alike");
  }
  result.ending = {
      .status = EndingStatus::direct,
      .reason = fmt::format("solved directly by normal equations in twice the working precision: {} "
                            "rows, {} coefficients",
                            training.rows(), found.identified.size())};
  progress.update("least squares", 1, 1);
  return result;
}

}  // namespace proofmass
