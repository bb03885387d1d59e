// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/eiv.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/design_matrix.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/static_fit.hpp"
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

OrthogonalDistanceFit solve(const Dataset& training, const TermList& terms, const std::vector<double>& start,
                            const Uncertainties& sigmas, const IdentifyOptions& options, Progress& progress) {
  const OrthogonalDistanceOptions limits{.iterations = options.uncertainty.iterations};
  const auto observer = [&](std::size_t iteration, double) {
    progress.update(kStage, iteration, limits.iterations);
    return !progress.cancelled();
  };
  const StaticSurface surface(terms, training.axes());
  OrthogonalDistanceFit fit =
      fit_orthogonal_distance(surface, observations(training, sigmas), start, limits, observer);
  if (fit.termination.cause == Cause::stopped) {
    throw Error(ErrorKind::interrupted, "interrupted during orthogonal distance regression");
  }
  if (fit.termination.cause == Cause::converged) return fit;
  throw refusal(fmt::format(
      "eiv did not converge: {}; the uncertainties given may be too large for these data, or the iterations "
      "too few (--eiv-iterations)",
      fit.termination.reason));
}

Matrix scaled(Matrix matrix, double factor) {
  for (std::size_t c = 0; c < matrix.columns(); ++c) {
    for (double& value : matrix.column(c)) value *= factor;
  }
  return matrix;
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

Identification identify_eiv(const Dataset& training, const Dataset& /*validation*/,
                            const IdentifyOptions& options, Progress& progress) {
  progress.update(kStage, 0, options.uncertainty.iterations);
  const Identifiability found = require_identifiable(training, options.terms, options.on_rank_loss);
  const LeastSquaresFit start =
      solve_least_squares(design_matrix(training, found.identified), training.output);
  const Uncertainties sigmas =
      find_uncertainties("eiv", training, found.identified, start.coefficients, options.uncertainty);
  if (progress.cancelled()) throw Error(ErrorKind::interrupted, "interrupted before the iteration");
  OrthogonalDistanceFit fit =
      solve(training, found.identified, start.coefficients, sigmas, options, progress);

  const double ratio = fit.sum_of_squares / static_cast<double>(fit.dof);
  const bool relative = options.uncertainty.scaling == ChiSquareScaling::scaled;
  Identification result =
      make_identification("eiv", training, options, found,
                          {.coefficients = std::move(fit.parameters),
                           .covariance = scaled(std::move(fit.unscaled_covariance), relative ? ratio : 1.0),
                           .vif = {}});
  add_residual_figures(result.diagnostics, training, residual_square_sum(training, result.static_model()),
                       found.identified.size());
  result.diagnostics.iterations = fit.iterations;
  auto& notes = result.diagnostics.notes;
  notes.insert(notes.end(), sigmas.notes.begin(), sigmas.notes.end());
  notes.push_back(describe_standard_errors(options.uncertainty.scaling, ratio));
  notes.emplace_back(
      "assumes errors of inputs and output that are independent from row to row and from axis to axis; "
      "errors "
      "common to many rows (radius, misalignment, speed of the stand) are not mended");
  result.history.push_back({"weighted_sum_of_squares", std::move(fit.history)});
  result.ending = {.status = EndingStatus::converged,
                   .reason = fmt::format("after {} iterations {}", fit.iterations, fit.termination.reason)};
  return result;
}

}  // namespace proofmass
