// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/search/afsa.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/design_matrix.hpp"
#include "proofmass/identify/model/ending_of.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/options/field_text.hpp"
#include "proofmass/identify/search/coefficient_space.hpp"
#include "proofmass/numeric/linear/least_squares.hpp"
#include "proofmass/numeric/optimise/fish_swarm.hpp"
#include "proofmass/numeric/random.hpp"

namespace proofmass {
namespace {

// Where the search ended, seen from the least-squares solution.
struct Distance {
  double rmse_ratio = 1.0;           // root mean square residual over the least there is
  double largest = 0.0;              // coefficient difference in standard errors of least squares
  Term term = Term::K0;              // whose it is
  std::vector<double> coefficients;  // differences, one a term
};

FishSettings settings_of(const Afsa& options) {
  return {.iterations = options.iterations,
          .tries = options.tries,
          .visual = options.visual,
          .step = options.step,
          .crowd_factor = options.crowd_factor,
          .decay = options.decay,
          .decay_rate = options.decay_rate,
          .decay_exponent = options.decay_exponent,
          .stall_iterations = options.stall_iterations,
          .target = options.target};
}

// Anywhere within the length of the output, along each coordinate.
std::vector<std::vector<double>> random_school(std::size_t fish, std::size_t dimensions, std::uint64_t seed) {
  std::vector<std::vector<double>> school(fish, std::vector<double>(dimensions));
  for (std::size_t i = 0; i < fish; ++i) {
    RandomStream random(seed, stream_id("first fish", i));
    for (double& x : school[i]) x = random.uniform(-1.0, 1.0);
  }
  return school;
}

FishResult search(const CoefficientSpace& space, const Afsa& method, std::uint64_t seed, Progress& progress) {
  const FishSettings settings = settings_of(method);
  const auto observe = [&](std::size_t iteration, double) {
    progress.update("fish swarm", iteration, settings.iterations);
    return !progress.cancelled();
  };
  FishResult result =
      minimise_by_fish([&space](std::span<const double> position) { return space.rmse(position); },
                       random_school(method.fish, space.dimensions(), seed), settings, seed, observe);
  if (progress.cancelled()) throw Error(ErrorKind::interrupted, "interrupted");
  return result;
}

double residual_sum_of_squares(const Matrix& design, const std::vector<double>& coefficients,
                               const std::vector<double>& output) {
  double sum = 0.0;
  for (std::size_t r = 0; r < design.rows(); ++r) {
    double residual = output[r];
    for (std::size_t c = 0; c < coefficients.size(); ++c) residual -= design(r, c) * coefficients[c];
    sum += residual * residual;
  }
  return sum;
}

Distance measure(const std::vector<double>& found, double rss, const LeastSquaresFit& best,
                 const TermList& terms) {
  Distance distance;
  if (best.rss > 0.0) distance.rmse_ratio = std::sqrt(rss / best.rss);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const double difference = found[k] - best.coefficients[k];
    distance.coefficients.push_back(difference);
    const double error = best.residual_sd() * std::sqrt(best.unscaled_covariance(k, k));
    if (error > 0.0 && std::abs(difference) > distance.largest * error) {
      distance.largest = std::abs(difference) / error;
      distance.term = terms[k];
    }
  }
  return distance;
}

// Mean square errors of the coefficients: the variance that noise gives to least squares, and the square of
// the known distance from it.
Matrix mean_square_error(const LeastSquaresFit& best, const std::vector<double>& distance) {
  Matrix result = best.unscaled_covariance;
  const double variance = best.residual_sd() * best.residual_sd();
  for (std::size_t c = 0; c < result.columns(); ++c) {
    for (std::size_t r = 0; r < result.rows(); ++r) {
      result(r, c) = variance * result(r, c) + distance[r] * distance[c];
    }
  }
  return result;
}

Ending ending_of_swarm(const FishResult& swarm) {
  return {.status = ending_status(swarm.termination.cause),
          .parts = {{.code = EndingCode::fish_swarm, .parts = ending_parts(swarm.termination)},
                    {.code = EndingCode::evaluations, .figures = {{"count", swarm.evaluations}}}}};
}

void add_findings(Identification& result, const Distance& distance, const Dataset& training) {
  constexpr double kFar = 1.0;  // standard errors
  result.findings.push_back({.code = Code::search_short_of_optimum,
                             .severity = distance.largest > kFar ? Severity::warning : Severity::note,
                             .terms = {distance.term},
                             .figures = {{"distance", distance.largest}, {"ratio", distance.rmse_ratio}}});
  result.findings.push_back({.code = Code::search_errors_added});
  note_unused_sigma(result, training);
}

void add_history(Identification& result, const FishResult& swarm) {
  const auto declared = [&result](std::vector<double> values) {
    for (double& value : values) value /= result.output_unit.to_canonical;
    return values;
  };
  result.history.push_back({"fish_best", declared(swarm.history)});
  result.history.push_back({"fish_mean", declared(swarm.mean_history)});
}

}  // namespace

Identification fit(const Afsa& method, const Dataset& training, const IdentifyOptions& options,
                   Progress& progress) {
  require_in_range(method);
  const Identifiability found = require_identifiable(training, options.terms, options.on_rank_loss);
  const Matrix design = design_matrix(training, found.identified);
  const CoefficientSpace space(design, training.output, method.coordinates);
  const FishResult swarm = search(space, method, options.seed, progress);
  std::vector<double> coefficients = space.coefficients(swarm.best);
  const double rss = residual_sum_of_squares(design, coefficients, training.output);

  const LeastSquaresFit best = solve_least_squares(design, training.output);
  const Distance distance = measure(coefficients, rss, best, found.identified);
  const StaticFit fit{.coefficients = std::move(coefficients),
                      .covariance = mean_square_error(best, distance.coefficients),
                      .vif = best.vif};
  Identification result = make_identification("afsa", training, options, found, fit);
  add_residual_figures(result.diagnostics, training, rss, found.identified.size());
  result.diagnostics.iterations = swarm.evaluations;
  result.details = AfsaDetails{.swarm_evaluations = swarm.evaluations,
                               .optimum_rmse_ratio = distance.rmse_ratio,
                               .optimum_distance = distance.largest};
  add_findings(result, distance, training);
  add_history(result, swarm);
  result.ending = ending_of_swarm(swarm);
  return result;
}

}  // namespace proofmass
