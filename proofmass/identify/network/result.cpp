// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/result.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/ending_status.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/model/term_sums.hpp"
#include "proofmass/identify/network/coefficients.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"

namespace proofmass {
namespace {

constexpr double kMisfit = 1.1;      // residual over least squares' beyond which noise is not the reason
constexpr double kRounding = 1e-12;  // root mean square residual of the scaled output that is no noise
constexpr double kSaturated = 0.99;  // |tanh| beyond this: the unit hardly answers its inputs

double saturated_share(const NetworkTask& task, const std::vector<double>& weights) {
  ColumnBlock phi(task.shape.output_weights(), task.samples.padded_rows());
  hidden_activations(task.shape, weights, task.samples, phi);
  std::size_t saturated = 0;
  for (std::size_t j = 0; j < task.shape.hidden; ++j) {
    for (std::size_t r = 0; r < task.samples.rows(); ++r)
      saturated += std::abs(phi.column(j)[r]) > kSaturated ? 1U : 0U;
  }
  return static_cast<double>(saturated) / static_cast<double>(task.shape.hidden * task.samples.rows());
}

// Replaces the projection's values by those of the expansion, which have no standard errors.
void use_expansion(Identification& result, const std::vector<double>& expansion, const TermList& terms) {
  for (Coefficient& coefficient : result.coefficients) {
    for (std::size_t k = 0; k < terms.size(); ++k) {
      if (terms[k] == coefficient.term) coefficient.value = expansion[k];
    }
    coefficient.standard_error.reset();
    if (coefficient.term == Term::Koq && coefficient.identified) {
      coefficient.identified = false;
      coefficient.reason = "|Ai|*Ai has no Taylor expansion at zero; use the projection";
    }
  }
  result.covariance.clear();
  result.diagnostics.notes.emplace_back(
      "coefficients are the network's Taylor expansion at zero specific force: no standard errors, and "
      "third-order "
      "terms far less certain than by projection");
}

// Names the terms for which expansion and projection differ by more than three standard errors: there the
// network is not the polynomial that the coefficients describe.
std::string disagreement(const Identification& result, const std::vector<double>& expansion,
                         const TermList& terms) {
  TermList differing;
  for (const Coefficient& coefficient : result.coefficients) {
    for (std::size_t k = 0; k < terms.size(); ++k) {
      if (terms[k] != coefficient.term || terms[k] == Term::Koq || !coefficient.standard_error) continue;
      if (std::abs(expansion[k] - coefficient.value) > 3.0 * *coefficient.standard_error)
        differing.push_back(terms[k]);
    }
  }
  if (differing.empty()) return {};
  return "Taylor expansion and projection differ by more than three standard errors in " +
         join_names(differing);
}

// What a residual beyond that of least squares means, or nothing when it is not beyond.
std::string misfit(const NetworkTask& task, double residual_sd) {
  const double floor = task.least_squares_rmse * output_half_range(task.network);
  if (!(floor > 0.0 && residual_sd > kMisfit * floor)) return {};
  const std::string how_much =
      task.least_squares_rmse > kRounding
          ? fmt::format("is {:.3g} times that of least squares with every separable term",
                        residual_sd / floor)
          : "is more than rounding, all that least squares with every separable term leaves";
  return "the network's residual " + how_much +
         ": misfit, not white noise, so the standard errors, intervals, t and p do not hold";
}

void add_coefficients(Identification& result, const NetworkTask& task, const IdentifyOptions& options,
                      const ProjectedCoefficients& projected) {
  const std::vector<double> expansion = expand_at_zero(*result.network, task.found.identified);
  auto& notes = result.diagnostics.notes;
  if (const std::string note = disagreement(result, expansion, task.found.identified); !note.empty()) {
    notes.push_back(note);
  }
  if (options.network.extraction == Extraction::taylor) {
    use_expansion(result, expansion, task.found.identified);
    return;
  }
  notes.emplace_back(
      "coefficients are the least-squares projection of the network onto the terms; their standard errors "
      "(delta "
      "method) assume exact inputs, white noise of one variance and a network trained to a minimum");
  const double residual_sd = result.diagnostics.residual_sd.value_or(0.0);
  if (std::string note = misfit(task, residual_sd); !note.empty()) notes.push_back(std::move(note));
  const double typical = residual_sd * std::sqrt(static_cast<double>(task.found.identified.size()) /
                                                 static_cast<double>(task.training.rows()));
  if (projected.induced_deviation > typical) {
    notes.push_back(
        fmt::format("the network's own misfit moves the coefficients by {:.3g} {} rms over the rows, more "
                    "than noise does ({:.3g}): "
                    "the standard errors are too small by about that ratio",
                    projected.induced_deviation, result.output_unit.canonical_symbol(), typical));
  }
}

// Refuses what is no fit: errors beyond all measure, or a network as it started that explains nothing.
void require_fit(std::string_view method, const NetworkTask& task, const TrainingState& best) {
  const std::string& reason = best.termination.reason;
  if (!std::isfinite(best.training_rmse)) {
    throw refusal(fmt::format("{} found no network with a finite error: {}", method, reason));
  }
  const std::vector<double>& output = task.training.output;
  const auto rows = static_cast<double>(output.size());
  const double mean = std::accumulate(output.begin(), output.end(), 0.0) / rows;
  double variance = 0.0;
  for (const double e : output) variance += (e - mean) * (e - mean) / rows;
  const double rmse = best.training_rmse * output_half_range(task.network);
  const double r2 = 1.0 - rmse * rmse / variance;
  if (best.epochs > 0 || r2 > 0.0) return;
  throw refusal(
      fmt::format("{} could not be trained: {} in the first epoch, and the network as it started explains "
                  "nothing of the output (R² {:.3g} on the training rows)",
                  method, reason, r2));
}

double least_squares_error(const Dataset& training, const TrainedNetwork& network) {
  const TermSums sums(training, parse_terms("full"));
  const TermList terms = analyse_identifiability(sums, sums.terms()).identified;
  if (terms.empty() || training.rows() < terms.size()) return 0.0;
  const double rss = solve_normal_equations(sums.gram(terms), sums.rows(terms)).rss;
  return std::sqrt(rss / static_cast<double>(training.rows())) / output_half_range(network);
}

}  // namespace

NetworkTask prepare_network(const Dataset& training, const Dataset& validation,
                            const IdentifyOptions& options) {
  Identifiability found = require_identifiable(training, options.terms, options.on_rank_loss);
  Dataset ordered = in_canonical_order(training);
  TrainedNetwork network = learn_scaling(ordered);
  network.hidden = options.network.hidden;
  const PerceptronShape shape{network.inputs.size(), network.hidden};
  if (ordered.rows() <= shape.parameters()) {
    throw bad_data({.file = training.source, .row = 0, .column = ""},
                   fmt::format("{} training rows", ordered.rows()),
                   fmt::format("at least {}: a {}-{}-1 network has {} weights", shape.parameters() + 1,
                               shape.inputs, shape.hidden, shape.parameters()));
  }
  Samples samples = scale_rows(network, ordered);
  std::optional<Samples> validation_samples;
  if (validation.rows() > 0) validation_samples = scale_rows(network, in_canonical_order(validation));
  const double least_squares = least_squares_error(ordered, network);
  return {.found = std::move(found),
          .training = std::move(ordered),
          .network = std::move(network),
          .shape = shape,
          .samples = std::move(samples),
          .validation = std::move(validation_samples),
          .least_squares_rmse = least_squares};
}

Identification make_network_identification(std::string_view method, const NetworkTask& task,
                                           const IdentifyOptions& options, const Refinement& refinement) {
  const TrainingState& best = refinement.best;
  require_fit(method, task, best);
  TrainedNetwork network = task.network;
  network.weights = canonical_weights(task.shape, best.weights);
  const ProjectedCoefficients projected = project_onto_terms(network, task.training, task.found.identified);

  Identification result = make_identification(method, task.training, options, task.found, projected.fit);
  const double scale = output_half_range(network);
  // Of the network as it is handed over: the trainer's own figure counts rounding as error, and its output
  // layer is solved once more at the end.
  add_residual_figures(result.diagnostics, task.training, projected.rss, task.shape.parameters());
  result.network = std::move(network);
  result.diagnostics.induced_deviation = projected.induced_deviation;
  result.diagnostics.saturated_share = saturated_share(task, result.network->weights);
  result.diagnostics.training_epochs = refinement.epochs;
  result.diagnostics.iterations = refinement.epochs;
  add_coefficients(result, task, options, projected);
  result.history.push_back({"training_rmse", best.training_curve});
  if (!best.validation_curve.empty()) result.history.push_back({"validation_rmse", best.validation_curve});
  for (Curve& curve : result.history) {
    for (double& value : curve.values) value *= scale / task.training.output_unit.to_canonical;
  }
  result.ending = {ending_status(best.termination.cause),
                   fmt::format("{} ({} epochs of the best of {} candidates)", best.termination.reason,
                               best.epochs, refinement.candidates)};
  return result;
}

}  // namespace proofmass
