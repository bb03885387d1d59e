// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/network/hybrid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/design_matrix.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/network/hybrid_network.hpp"
#include "proofmass/identify/network/hybrid_validation.hpp"
#include "proofmass/identify/network/scaling.hpp"
#include "proofmass/identify/options/field_text.hpp"
#include "proofmass/numeric/linear/least_squares.hpp"

namespace proofmass {
namespace {

// Schwarz 1978 for Gaussian errors of unknown variance, without constants: n ln(RSS / n) + p ln n.
double information_criterion(double rss, std::size_t parameters, std::size_t rows) {
  const auto n = static_cast<double>(rows);
  return n * std::log(rss / n) + static_cast<double>(parameters) * std::log(n);
}

// Whether least squares leaves nothing but rounding.
bool is_rounding(double rss, const Dataset& training) {
  constexpr double kRounding = 1e-13;  // of the output's half range, a row
  const double half = output_half_range(learn_scaling(training));
  return rss <= static_cast<double>(training.rows()) * kRounding * kRounding * half * half;
}

// The best fit with hidden units, if any beats least squares, the criterion by number of units, from zero,
// and what cross-validation said of the number that it chose.
struct Search {
  std::optional<HybridFit> best;
  std::vector<double> criterion;
  std::vector<EndingStatus> training;  // how that of each network ended, from one unit
  std::size_t chosen = 0;              // units by the criterion
  bool falls_at_limit = false;         // the most units allowed have the least criterion
  HybridValidation validation;
  std::size_t epochs = 0;
  std::size_t evaluations = 0;  // of the swarms' fitness
};

Search search(const Hybrid& method, const Dataset& training, const TermList& terms, double rss,
              std::uint64_t seed, Progress& progress) {
  Search found;
  found.criterion = {information_criterion(rss, terms.size(), training.rows())};
  double least = found.criterion.front();
  std::size_t failures = 0;
  for (std::size_t hidden = 1; hidden <= method.most_hidden && failures < method.patience; ++hidden) {
    const std::size_t parameters = terms.size() + hidden * (training.axes().size() + 2);
    // A residual of rounding alone needs no network, and few rows afford none.
    if (training.rows() <= 2 * parameters || is_rounding(rss, training)) break;
    HybridFit fit = fit_hybrid(method, training, terms, hidden, seed, progress);
    progress.update("hidden units", hidden, method.most_hidden);
    found.epochs += fit.epochs;
    found.evaluations += fit.evaluations;
    found.criterion.push_back(information_criterion(fit.rss, fit.parameters, training.rows()));
    found.training.push_back(fit.training);
    if (found.criterion.back() < least) {
      least = found.criterion.back();
      found.best = std::move(fit);
      failures = 0;
    } else {
      ++failures;
    }
  }
  found.chosen = found.best ? found.best->network.hidden : 0;
  found.falls_at_limit = found.chosen > 0 && found.chosen == method.most_hidden;
  return found;
}

// The criterion takes noise to be normal: it would have a network follow outliers. So a network stays only
// when it also predicts rows that it has not seen better than the terms alone.
void cross_validate(Search& found, const Hybrid& method, const Dataset& training, const TermList& terms,
                    std::uint64_t seed, Progress& progress) {
  if (!found.best) return;
  found.validation = validate_hybrid(method, training, terms, found.chosen, seed, progress);
  found.epochs += found.validation.epochs;
  found.evaluations += found.validation.evaluations;
  if (!found.validation.favours_network()) found.best.reset();
}

EndingPart account_of(const HybridValidation& validation, bool kept) {
  if (validation.rows == 0) return {.code = EndingCode::network_not_judged};
  return {.code = kept ? EndingCode::network_kept : EndingCode::network_dropped,
          .figures = {{"ratio", validation.rmse_with / validation.rmse_without}}};
}

// "1, 2": the units of the networks whose training used all epochs.
std::string unfinished_sizes(const std::vector<EndingStatus>& training) {
  std::string sizes;
  for (std::size_t k = 0; k < training.size(); ++k) {
    if (training[k] != EndingStatus::iteration_limit) continue;
    sizes += fmt::format("{}{}", sizes.empty() ? "" : ", ", k + 1);
  }
  return sizes;
}

std::vector<EndingPart> account_of(const Search& found, const Hybrid& method) {
  EndingPart compared{
      .code = found.falls_at_limit ? EndingCode::sizes_compared_to_limit : EndingCode::sizes_compared,
      .figures = {{"chosen", found.chosen}}};
  for (std::size_t h = 0; h < found.criterion.size(); ++h) {
    compared.parts.push_back(
        {.code = EndingCode::size_compared,
         .figures = {{"units", h}, {"difference", found.criterion[h] - found.criterion.front()}}});
  }
  std::vector<EndingPart> parts{std::move(compared)};
  if (found.chosen > 0) parts.push_back(account_of(found.validation, found.best.has_value()));
  if (std::string sizes = unfinished_sizes(found.training); !sizes.empty()) {
    const double units = sizes == "1" ? 1.0 : 2.0;  // of which the words depend
    parts.push_back({.code = EndingCode::sizes_unfinished,
                     .figures = {{"epochs", method.epochs}, {"sizes", std::move(sizes)}, {"units", units}}});
  }
  return parts;
}

// A search that found nothing better than no hidden unit has converged.
EndingStatus status_of_end(const Search& found) {
  if (found.falls_at_limit) return EndingStatus::iteration_limit;
  return found.chosen > 0 ? found.training[found.chosen - 1] : EndingStatus::converged;
}

void add_network(Identification& result, Search& found, const Dataset& training) {
  HybridFit& fit = *found.best;
  const double half = output_half_range(fit.network) / training.output_unit.to_canonical;
  for (double& value : fit.curve) value *= half;
  for (double& value : fit.swarm) value *= half;
  result.history.push_back({"training_rmse", std::move(fit.curve)});
  result.history.push_back({"swarm_best", std::move(fit.swarm)});
  result.network = std::move(fit.network);
  result.findings.push_back({.code = Code::structure_beyond_terms, .severity = Severity::warning});
}

}  // namespace

Identification fit(const Hybrid& method, const Dataset& unordered, const IdentifyOptions& options,
                   Progress& progress) {
  require_in_range(method);
  if (std::find(options.terms.begin(), options.terms.end(), Term::K0) == options.terms.end()) {
    throw usage_error("hybrid needs K0 among the terms: its network has a constant of its own");
  }
  const Identifiability terms = require_identifiable(unordered, options.terms, options.on_rank_loss);
  const Dataset training = in_canonical_order(unordered);
  LeastSquaresFit solution = solve_least_squares(design_matrix(training, terms.identified), training.output);
  Search found = search(method, training, terms.identified, solution.rss, options.seed, progress);
  cross_validate(found, method, training, terms.identified, options.seed, progress);
  const double rss = found.best ? found.best->rss : solution.rss;
  const std::size_t parameters = found.best ? found.best->parameters : terms.identified.size();

  // With the terms in its tangent space the fit's projection onto them is that of the data: least squares'
  // coefficients, with the smaller variance of what the network leaves.
  const double variance = rss / static_cast<double>(training.rows() - parameters);
  const StaticFit fit{.coefficients = std::move(solution.coefficients),
                      .covariance = scaled(std::move(solution.unscaled_covariance), variance),
                      .vif = std::move(solution.vif)};
  Identification result = make_identification("hybrid", training, options, terms, fit);
  add_residual_figures(result.diagnostics, training, rss, parameters);
  NetworkDetails details;
  details.training_epochs = found.epochs;
  details.swarm_evaluations = found.evaluations;
  result.details = std::move(details);
  const std::size_t iterations = found.epochs + found.evaluations;
  if (iterations > 0) result.diagnostics.iterations = iterations;
  result.ending = {.status = status_of_end(found), .parts = account_of(found, method)};
  result.history.push_back({"information_criterion", found.criterion});
  result.findings.push_back({.code = Code::hidden_choice_ignored});
  if (found.best) add_network(result, found, training);
  return result;
}

}  // namespace proofmass
