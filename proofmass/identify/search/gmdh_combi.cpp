// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <utility>

#include "proofmass/core/error.hpp"
#include "proofmass/identify/model/design_matrix.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/static_fit.hpp"
#include "proofmass/identify/model/term_sums.hpp"
#include "proofmass/identify/search/gmdh_criterion.hpp"
#include "proofmass/identify/search/gmdh_forms.hpp"
#include "proofmass/numeric/linear/column_scaling.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"
#include "proofmass/numeric/selection/subset_search.hpp"

namespace proofmass {
namespace {

Matrix scaled_design(const Dataset& training, const TermList& terms) {
  Matrix design = design_matrix(training, terms);
  const std::vector<double> scales = column_scales(design);
  for (std::size_t c = 0; c < design.columns(); ++c) {
    for (double& value : design.column(c)) value *= scales[c];
  }
  return design;
}

// A mean square that rounding of the output and of the arithmetic can explain: without it a record free of
// noise would choose terms by rounding errors.
double rounding_floor(const std::vector<double>& output) {
  double sum = 0.0;
  for (const double value : output) sum += value * value;
  return std::pow(16.0 * std::numeric_limits<double>::epsilon(), 2) * sum /
         static_cast<double>(output.size());
}

SubsetSearchResult choose(const SubsetCriterion& criterion, const Dataset& training, const Gmdh& options,
                          Progress& progress) {
  const SubsetSearchSettings settings{.beam = options.beam,
                                      .models = options.models,
                                      .tolerance = std::pow(1.0 + options.tolerance, 2) - 1.0,
                                      .floor = rounding_floor(training.output)};
  const std::size_t most = std::min<std::size_t>(options.models, (std::size_t{1} << criterion.columns()) - 1);
  SubsetSearchResult found = search_subsets(criterion, settings, [&](std::size_t done) {
    progress.update("gmdh candidates", done, std::max(done, most));
    return !progress.cancelled();
  });
  if (progress.cancelled()) throw Error(ErrorKind::interrupted, "interrupted in the search for terms");
  return found;
}

// Terms that cannot be judged are not left out either: they may be the largest.
void require_judgeable(const SubsetCriterion& criterion, const Dataset& training) {
  const auto all = static_cast<Subset>((std::uint64_t{1} << criterion.columns()) - 1);
  if (std::isfinite(criterion.value(all))) return;
  throw refusal(
      message("{}: leaving one row out cannot judge terms that one row alone identifies (its leverage is "
              "1); measure "
              "such positions again, ask for fewer terms, or use ols, which does not choose terms",
              training.source),
      {{"terms", ""}});
}

TermList chosen_terms(const TermList& candidates, Subset subset) {
  TermList chosen;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if ((subset >> k & 1U) != 0U) chosen.push_back(candidates[k]);
  }
  return chosen;
}

StaticFit refit(const NormalSolution& solution) {
  const double variance = solution.rss / static_cast<double>(solution.dof);
  return {.coefficients = solution.coefficients,
          .covariance = scaled(solution.unscaled_covariance, variance),
          .vif = solution.vif};
}

void explain_left_out(Identification& result, const TermList& candidates, const SubsetCriterion& criterion,
                      const SubsetSearchResult& found) {
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if ((found.best >> k & 1U) != 0U) continue;
    for (Coefficient& c : result.coefficients) {
      if (c.term != candidates[k]) continue;
      c.left_out = true;
      c.reason = {.code = Code::term_left_out,
                  .terms = {c.term},
                  .figures = {{"without", std::sqrt(found.value)},
                              {"with", std::sqrt(criterion.value(found.best | Subset{1} << k))},
                              {"unit", result.output_unit.canonical_symbol()}}};
    }
  }
}

Curve criterion_curve(const SubsetSearchResult& found) {
  Curve curve{.name = "criterion_by_terms", .values = {}};
  for (const double value : found.value_of_size) curve.values.push_back(std::sqrt(value));
  return curve;
}

void add_findings(Identification& result, const GmdhRows& rows, const SubsetSearchResult& found,
                  std::size_t candidates, const TermList& chosen) {
  Finding choice{.code = Code::terms_chosen, .terms = chosen, .figures = rows.figures()};
  choice.figures.emplace_back("count", chosen.size());
  choice.figures.emplace_back("total", candidates);
  choice.figures.emplace_back("value", std::sqrt(found.value));
  choice.figures.emplace_back("unit", result.output_unit.canonical_symbol());
  result.findings.push_back(std::move(choice));
  result.findings.push_back({.code = Code::choice_taken_as_given});
  result.findings.push_back({.code = Code::white_noise_assumed});
}

Ending ending_of(const SubsetSearchResult& found, std::size_t candidates) {
  const auto models = static_cast<double>((std::uint64_t{1} << candidates) - 1);
  return {.status = found.proven ? EndingStatus::converged : EndingStatus::iteration_limit,
          .parts = {{.code = EndingCode::subsets_searched,
                     .figures = {{"count", found.evaluations}, {"total", models}}},
                    {.code = found.proven ? EndingCode::subsets_proven : EndingCode::subsets_not_proven}}};
}

}  // namespace

Identification identify_gmdh_combi(const Gmdh& method, const Dataset& training,
                                   const IdentifyOptions& options, Progress& progress) {
  const TermSums sums(training, options.terms);
  const Identifiability all = require_identifiable(sums, options.on_rank_loss);
  const GmdhRows rows(training, all.identified, method, options.seed);
  const auto criterion = rows.criterion(scaled_design(training, all.identified), training.output);
  require_judgeable(*criterion, training);
  const SubsetSearchResult found = choose(*criterion, training, method, progress);

  const TermList chosen = chosen_terms(all.identified, found.best);
  Identifiability kept = analyse_identifiability(sums, chosen);
  kept.unidentified = all.unidentified;
  const NormalSolution solution = solve_normal_equations(sums.gram(chosen), sums.rows(chosen));
  Identification result = make_identification("gmdh", training, options, kept, refit(solution));
  explain_left_out(result, all.identified, *criterion, found);
  add_residual_figures(result.diagnostics, training, solution.rss, chosen.size());
  add_findings(result, rows, found, all.identified.size(), chosen);
  result.details = GmdhDetails{.models_tried = found.evaluations};
  result.diagnostics.iterations = found.evaluations;
  result.history.push_back(criterion_curve(found));
  result.ending = ending_of(found, all.identified.size());
  return result;
}

}  // namespace proofmass
