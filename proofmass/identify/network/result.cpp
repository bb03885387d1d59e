// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/result.hpp"

#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/ending_of.hpp"
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

double saturated_fraction(const NetworkTask& task, const std::vector<double>& weights) {
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
      coefficient.reason = {.code = Code::term_without_expansion, .terms = {coefficient.term}};
    }
  }
  result.covariance.clear();
  result.findings.push_back({.code = Code::coefficients_expanded});
}

// The terms for which expansion and projection differ by more than three standard errors: there the network
// is not the polynomial that the coefficients describe.
TermList differing_terms(const Identification& result, const std::vector<double>& expansion,
                         const TermList& terms) {
  TermList differing;
  for (const Coefficient& coefficient : result.coefficients) {
    for (std::size_t k = 0; k < terms.size(); ++k) {
      if (terms[k] != coefficient.term || terms[k] == Term::Koq || !coefficient.standard_error) continue;
      if (std::abs(expansion[k] - coefficient.value) > 3.0 * *coefficient.standard_error)
        differing.push_back(terms[k]);
    }
  }
  return differing;
}

// Says what a residual beyond that of least squares means. Both residuals are compared by their degrees of
// freedom: the root mean square over the rows alone falls with the number of parameters.
void note_misfit(Identification& result, const NetworkTask& task, double residual_sd) {
  const double floor = task.least_squares_sd * output_half_range(task.network);
  if (!(floor > 0.0 && residual_sd > kMisfit * floor)) return;
  if (task.leaves_noise()) {
    result.findings.push_back({.code = Code::network_misfit,
                               .severity = Severity::warning,
                               .figures = {{"ratio", residual_sd / floor}}});
  } else {
    result.findings.push_back({.code = Code::network_above_rounding, .severity = Severity::warning});
  }
}

void add_coefficients(Identification& result, const NetworkTask& task, Extraction extraction,
                      const ProjectedCoefficients& projected) {
  const TermList& terms = task.found.identified;
  const std::vector<double> expansion = expand_at_zero(*result.network, terms);
  if (TermList differing = differing_terms(result, expansion, terms); !differing.empty()) {
    result.findings.push_back({.code = Code::expansion_differs, .terms = std::move(differing)});
  }
  const double residual_sd = result.diagnostics.residual_sd.value_or(0.0);
  note_misfit(result, task, residual_sd);
  if (extraction == Extraction::taylor) {
    use_expansion(result, expansion, terms);
    return;
  }
  result.findings.push_back({.code = Code::coefficients_projected});
  if (!result.covariance.empty()) result.findings.push_back({.code = Code::network_errors_compared});
  const double typical =
      residual_sd * std::sqrt(static_cast<double>(terms.size()) / static_cast<double>(task.training.rows()));
  if (projected.induced_deviation > typical) {
    result.findings.push_back({.code = Code::network_moves_coefficients,
                               .severity = Severity::note,
                               .figures = {{"induced", projected.induced_deviation},
                                           {"typical", typical},
                                           {"unit", result.output_unit.canonical_symbol()}}});
  }
}

Ending ending_of_training(const TrainingState& best, std::size_t candidates) {
  Ending end = training_end(best);
  EndingPart effort{.code = EndingCode::best_candidate,
                    .figures = {{"epochs", best.epochs}, {"candidates", candidates}},
                    .parts = std::move(end.parts)};
  return {.status = end.status, .parts = {std::move(effort)}};
}

// Refuses what is no fit: errors beyond all measure, or a network as it started that explains nothing.
void require_fit(std::string_view method, const NetworkTask& task, const TrainingState& best) {
  if (!std::isfinite(best.training_rmse)) {
    throw refusal(message("{} found no network with a finite error", method))
        .with_ending(ending_parts(best.termination));
  }
  const std::vector<double>& output = task.training.output;
  const auto rows = static_cast<double>(output.size());
  const double mean = std::accumulate(output.begin(), output.end(), 0.0) / rows;
  double variance = 0.0;
  for (const double e : output) variance += (e - mean) * (e - mean) / rows;
  const double rmse = best.training_rmse * output_half_range(task.network);
  const double r2 = 1.0 - rmse * rmse / variance;
  if (best.epochs > 0 || r2 > 0.0) return;
  throw refusal(message("{} could not be trained: training ended in the first epoch, and the network "
                        "as it started explains nothing of the output (R² {:.3g} on the training rows)",
                        method, r2))
      .with_ending(ending_parts(best.termination));
}

// Of the scaled output, over the rows and over the degrees of freedom.
struct LeastSquaresError {
  double rmse = 0.0;
  double sd = 0.0;
  StaticModel model;
};

LeastSquaresError least_squares_error(const Dataset& training, const TrainedNetwork& network) {
  const TermSums sums(training, parse_terms("full"));
  const TermList terms = analyse_identifiability(sums, sums.terms()).identified;
  if (terms.empty() || training.rows() < terms.size()) return {};
  NormalSolution solution = solve_normal_equations(sums.gram(terms), sums.rows(terms));
  const double rss = solution.rss;
  const double half_range = output_half_range(network);
  const std::size_t dof = training.rows() - terms.size();
  return {.rmse = std::sqrt(rss / static_cast<double>(training.rows())) / half_range,
          .sd = dof > 0 ? std::sqrt(rss / static_cast<double>(dof)) / half_range : 0.0,
          .model = {.terms = terms, .coefficients = std::move(solution.coefficients)}};
}

}  // namespace

bool NetworkTask::leaves_noise() const noexcept {
  return least_squares_rmse > kRounding && least_squares_sd > 0.0;
}

NetworkTask prepare_network(const NetworkOptions& asked, const Dataset& training, const Dataset& validation,
                            const IdentifyOptions& options) {
  Identifiability found = require_identifiable(training, options.terms, options.on_rank_loss);
  Dataset ordered = in_canonical_order(training);
  TrainedNetwork network = learn_scaling(ordered);
  if (!asked.hidden) throw usage_error("hidden: a search has no end here; expected a number of hidden units");
  network.hidden = *asked.hidden;
  const PerceptronShape shape{network.inputs.size(), network.hidden};
  if (ordered.rows() <= shape.parameters()) {
    throw bad_data({.file = training.source, .row = 0, .column = ""},
                   amount_of(ordered.rows(), "training row", "training rows"),
                   message("at least {}: a {}-{}-1 network has {}", shape.parameters() + 1, shape.inputs,
                           shape.hidden, amount_of(shape.parameters(), "weight", "weights")),
                   {{"hidden", ""}});
  }
  Samples samples = scale_rows(network, ordered);
  std::optional<Samples> validation_samples;
  if (validation.rows() > 0) validation_samples = scale_rows(network, in_canonical_order(validation));
  LeastSquaresError least_squares = least_squares_error(ordered, network);
  return {.found = std::move(found),
          .training = std::move(ordered),
          .network = std::move(network),
          .shape = shape,
          .samples = std::move(samples),
          .validation = std::move(validation_samples),
          .least_squares_rmse = least_squares.rmse,
          .least_squares_sd = least_squares.sd,
          .least_squares = std::move(least_squares.model)};
}

Identification make_network_identification(std::string_view method, const NetworkTask& task,
                                           Extraction extraction, const IdentifyOptions& options,
                                           const Refinement& refinement) {
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
  NetworkDetails details;
  details.saturated_fraction = saturated_fraction(task, result.network->weights);
  details.induced_deviation = projected.induced_deviation;
  details.training_epochs = refinement.epochs;
  result.details = std::move(details);
  result.diagnostics.iterations = refinement.epochs;
  add_coefficients(result, task, extraction, projected);
  result.history.push_back({"training_rmse", best.training_curve});
  if (!best.validation_curve.empty()) result.history.push_back({"validation_rmse", best.validation_curve});
  for (Curve& curve : result.history) {
    for (double& value : curve.values) value *= scale / task.training.output_unit.to_canonical;
  }
  result.training_path = best.path;
  result.ending = ending_of_training(best, refinement.candidates);
  return result;
}

}  // namespace proofmass
