// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/ending_of.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/model/term_sums.hpp"
#include "proofmass/identify/search/gmdh_criterion.hpp"
#include "proofmass/identify/search/gmdh_forms.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"
#include "proofmass/numeric/selection/quadratic_layers.hpp"

namespace proofmass {
namespace {

// The largest magnitude along each axis. Inputs are scaled by it and not shifted: the polynomial stays one
// about A = 0, and cutting it off above degree three loses nothing of the lower degrees.
using Scales = std::array<double, 3>;

Scales scales_of(const Dataset& training) {
  Scales scales{1.0, 1.0, 1.0};
  for (const Axis axis : kAxes) {
    double largest = 0.0;
    for (const double value : training.along(axis)) largest = std::max(largest, std::abs(value));
    if (largest > 0.0) scales[static_cast<std::size_t>(axis)] = largest;
  }
  return scales;
}

bool uses(const TermList& terms, Axis axis) {
  return std::any_of(terms.begin(), terms.end(), [axis](Term term) { return info(term).uses(axis); });
}

std::vector<PolynomialNode> make_inputs(const Dataset& training, const TermList& terms,
                                        const Scales& scales) {
  std::vector<PolynomialNode> inputs;
  for (const Axis axis : kAxes) {
    if (!uses(terms, axis)) continue;
    const auto k = static_cast<std::size_t>(axis);
    inputs.push_back({.values = training.along(axis), .jet = PolynomialJet::variable(k)});
    for (double& value : inputs.back().values) value /= scales[k];
  }
  if (std::find(terms.begin(), terms.end(), Term::Koq) != terms.end()) {
    inputs.push_back({.values = inputs.front().values, .jet = PolynomialJet::marked_variable()});
    for (double& value : inputs.back().values) value *= std::abs(value);
  }
  if (inputs.size() < 2) {
    throw refusal(
        "the neurons of gmdh form mia take two inputs, and the terms use one; ask for terms of "
        "another axis, or for form combi");
  }
  return inputs;
}

StaticModel expanded(const PolynomialJet& jet, const TermList& terms, const Scales& scales) {
  StaticModel model;
  for (const Term term : terms) {
    const auto& powers = info(term).powers;
    double value = term == Term::Koq ? jet.marked : jet.coefficient(powers);
    for (std::size_t k = 0; k < powers.size(); ++k) value /= std::pow(scales[k], powers[k]);
    model.terms.push_back(term);
    model.coefficients.push_back(value);
  }
  return model;
}

double rms_difference(const Dataset& training, const StaticModel& model, const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t r = 0; r < values.size(); ++r) {
    const double difference = values[r] - model.output(training.at(r));
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(values.size()));
}

void add_expansion_findings(Identification& result, const Dataset& training, const QuadraticLayers& network,
                            const StaticModel& model, const StaticModel& every_term) {
  const std::string unit = result.output_unit.canonical_symbol();
  const double by_network = rms_difference(training, {}, [&] {
    std::vector<double> residuals = training.output;
    for (std::size_t r = 0; r < residuals.size(); ++r) residuals[r] -= network.best.values[r];
    return residuals;
  }());
  result.findings.push_back({.code = Code::layers_expanded,
                             .figures = {{"network", by_network},
                                         {"expansion", rms_difference(training, model, training.output)},
                                         {"unit", unit}}});
  result.findings.push_back(
      {.code = Code::layers_beyond_terms,
       .figures = {{"beyond_all", rms_difference(training, every_term, network.best.values)},
                   {"beyond_asked", rms_difference(training, model, network.best.values)},
                   {"unit", unit}}});
  result.findings.push_back({.code = Code::layers_without_errors});
  if (network.discarded > 0) {
    result.findings.push_back({.code = Code::pairs_discarded,
                               .figures = {{"count", network.discarded}, {"total", network.neurons}}});
  }
}

void note_distance_from_least_squares(Identification& result, const Dataset& training,
                                      const StaticModel& model) {
  constexpr double kFar = 1.1;
  const TermSums sums(training, model.terms);
  const double least = std::sqrt(solve_normal_equations(sums.gram(model.terms), sums.rows(model.terms)).rss /
                                 static_cast<double>(training.rows()));
  const double ratio = rms_difference(training, model, training.output) / least;
  if (!(ratio > kFar)) return;
  result.findings.push_back(
      {.code = Code::layers_short_of_optimum, .severity = Severity::warning, .figures = {{"ratio", ratio}}});
}

QuadraticLayers grow(const Dataset& training, const std::vector<PolynomialNode>& inputs, const GmdhRows& rows,
                     const Gmdh& options, Progress& progress) {
  const QuadraticLayerSettings settings{.layers = options.layers,
                                        .survivors = options.survivors,
                                        .inputs_in_every_layer = options.inputs_in_every_layer,
                                        .improvement = options.improvement};
  const auto criterion = [&rows](const Matrix& design, std::span<const double> y) {
    return rows.criterion(design, y);
  };
  const auto observer = [&](std::size_t layer, double) {
    progress.update("gmdh layers", layer, options.layers);
    return !progress.cancelled();
  };
  QuadraticLayers network =
      grow_quadratic_layers(inputs, training.output, rows.fitting(), criterion, settings, observer);
  if (network.termination.cause == Cause::stopped)
    throw Error(ErrorKind::interrupted, "interrupted while growing layers");
  if (network.layer == 0) {
    throw refusal(
        "no quadratic neuron can be fitted: the rows cannot tell apart 1, u, v, u*v, u^2 and v^2 "
        "of any two inputs, or one row alone identifies one of these, so that leaving it out cannot judge "
        "it; "
        "form combi may do");
  }
  return network;
}

}  // namespace

Identification identify_gmdh_mia(const Gmdh& method, const Dataset& training, const IdentifyOptions& options,
                                 Progress& progress) {
  const Identifiability found = require_identifiable(training, options.terms, options.on_rank_loss);
  const GmdhRows rows(training, found.identified, method, options.seed);
  const Scales scales = scales_of(training);
  const std::vector<PolynomialNode> inputs = make_inputs(training, found.identified, scales);
  const QuadraticLayers network = grow(training, inputs, rows, method, progress);

  const StaticModel model = expanded(network.best.jet, found.identified, scales);
  Identification result = make_identification(
      "gmdh", training, options, found, {.coefficients = model.coefficients, .covariance = {}, .vif = {}});
  Finding growth{.code = Code::layers_grown, .figures = rows.figures()};
  growth.figures.emplace_back("inputs", inputs.size());
  growth.figures.emplace_back("layer", network.layer);
  growth.figures.emplace_back("value", std::sqrt(network.value));
  growth.figures.emplace_back("unit", result.output_unit.canonical_symbol());
  result.findings.push_back(std::move(growth));
  note_distance_from_least_squares(result, training, model);
  const StaticModel every_term = expanded(network.best.jet, parse_terms("full"), scales);
  add_expansion_findings(result, training, network, model, every_term);
  result.details = GmdhDetails{.models_tried = network.neurons};
  result.diagnostics.iterations = network.neurons;
  Curve curve{.name = "criterion_by_layer", .values = {}};
  for (const double value : network.value_of_layer) curve.values.push_back(std::sqrt(value));
  result.history.push_back(std::move(curve));
  result.ending = ending_of(network.termination);
  return result;
}

}  // namespace proofmass
