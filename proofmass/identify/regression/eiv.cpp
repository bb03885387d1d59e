// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/eiv.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/design_matrix.hpp"
#include "proofmass/identify/model/ending_of.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/options/field_text.hpp"
#include "proofmass/identify/regression/static_surface.hpp"
#include "proofmass/identify/regression/uncertainties.hpp"
#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/regression/orthogonal_distance.hpp"

namespace proofmass {
namespace {

constexpr std::string_view kStage = "orthogonal distance regression";

SurfaceObservations observations(const Dataset& data, const Uncertainties& sigmas) {
  SurfaceObservations observed;
  for (const Axis axis : data.axes()) {
    observed.inputs.emplace_back(data.along(axis));
    observed.input_sigma.emplace_back(sigmas.input[static_cast<std::size_t>(axis)]);
  }
  observed.output = data.output;
  observed.output_sigma = sigmas.output;
  return observed;
}

// The factors by which the terms beside K0 are taken larger, or turned round, to start from.
constexpr std::array kStartFactors{1.0, 4.0, 16.0, 64.0, -1.0, -4.0, -16.0, -64.0};

// Least squares first. Uncertain inputs bias it towards zero; where they are so uncertain that it leads to no
// good end, its multiples may, each with the K0 that makes the weighted mean residual zero.
std::vector<std::vector<double>> starts(const Matrix& design, const TermList& terms,
                                        const std::vector<double>& least_squares,
                                        const std::vector<double>& output_sigma) {
  std::vector<double> means(terms.size(), 0.0);  // weighted, of the regressors
  double total = 0.0;
  for (std::size_t row = 0; row < output_sigma.size(); ++row) {
    const double weight = 1.0 / (output_sigma[row] * output_sigma[row]);
    total += weight;
    for (std::size_t k = 0; k < terms.size(); ++k) means[k] += weight * design(row, k);
  }
  std::vector<std::vector<double>> result;
  for (const double factor : kStartFactors) {
    std::vector<double> start = least_squares;
    double shift = 0.0;
    for (std::size_t k = 0; k < terms.size(); ++k) {
      if (terms[k] == Term::K0) continue;
      start[k] *= factor;
      shift += (least_squares[k] - start[k]) * means[k] / total;
    }
    for (std::size_t k = 0; k < terms.size(); ++k) {
      if (terms[k] == Term::K0) start[k] += shift;
    }
    result.push_back(std::move(start));
  }
  return result;
}

OrthogonalDistanceFit solve(const Dataset& training, const TermList& terms,
                            const std::vector<std::vector<double>>& starts, const Uncertainties& sigmas,
                            std::size_t iterations, Progress& progress) {
  const OrthogonalDistanceOptions limits{.iterations = iterations};
  const auto observer = [&](std::size_t iteration, double) {
    progress.update(kStage, iteration, limits.iterations);
    return !progress.cancelled();
  };
  const StaticSurface surface(terms, training.axes());
  OrthogonalDistanceFit fit =
      fit_orthogonal_distance_from(surface, observations(training, sigmas), starts, limits, observer);
  if (fit.termination.cause == Cause::stopped) {
    throw Error(ErrorKind::interrupted, "interrupted during orthogonal distance regression");
  }
  if (fit.termination.cause == Cause::converged) return fit;
  throw refusal(
      "eiv did not converge: the uncertainties given may be too large for these data, or the iterations too "
      "few",
      fit.termination.cause == Cause::iteration_limit ? std::vector<Remedy>{{"eiv-iterations", ""}}
                                                      : std::vector<Remedy>{})
      .with_ending(ending_parts(fit.termination));
}

// Of the output at the accelerations as recorded: what prediction will leave.
double residual_square_sum(const Dataset& data, const StaticModel& model) {
  double sum = 0.0;
  for (std::size_t row = 0; row < data.rows(); ++row) {
    const double residual = data.output[row] - model.output(data.at(row));
    sum += residual * residual;
  }
  return sum;
}

}  // namespace

SigmaColumns Eiv::sigma_columns() const noexcept { return uncertainty.sigma_columns(); }

Identification fit(const Eiv& method, const Dataset& training, const IdentifyOptions& options,
                   Progress& progress) {
  require_in_range(method);
  progress.update(kStage, 0, method.iterations);
  const Identifiability found =
      require_identifiable(training, options.terms, options.on_rank_loss, method.uncertainty.input);
  const Matrix design = design_matrix(training, found.identified);
  const LeastSquaresFit start = solve_least_squares(design, training.output);
  const Uncertainties sigmas =
      find_uncertainties("eiv", training, found.identified, start.coefficients, method.uncertainty);
  if (progress.cancelled()) throw Error(ErrorKind::interrupted, "interrupted before the iteration");
  OrthogonalDistanceFit fit =
      solve(training, found.identified, starts(design, found.identified, start.coefficients, sigmas.output),
            sigmas, method.iterations, progress);

  const double ratio = fit.sum_of_squares / static_cast<double>(fit.dof);
  const bool relative = method.uncertainty.scaling == ChiSquareScaling::scaled;
  Identification result =
      make_identification("eiv", training, options, found,
                          {.coefficients = std::move(fit.parameters),
                           .covariance = scaled(std::move(fit.unscaled_covariance), relative ? ratio : 1.0),
                           .vif = {}});
  add_residual_figures(result.diagnostics, training, residual_square_sum(training, result.static_model()),
                       found.identified.size());
  result.diagnostics.iterations = fit.iterations;
  result.row_weights = {.values = effective_weights(sigmas, result.static_model(), training), .fixed = false};
  result.findings.insert(result.findings.end(), sigmas.findings.begin(), sigmas.findings.end());
  result.findings.push_back(explain_standard_errors(method.uncertainty.scaling, ratio));
  result.findings.push_back({.code = Code::independent_errors_assumed});
  result.history.push_back({"weighted_sum_of_squares", std::move(fit.history)});
  result.ending = {.status = ending_status(fit.termination.cause),
                   .parts = {{.code = EndingCode::after_iterations,
                              .figures = {{"iterations", fit.iterations}},
                              .parts = ending_parts(fit.termination)}}};
  return result;
}

}  // namespace proofmass
