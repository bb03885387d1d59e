// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/short_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

#include "proofmass/assess/diagnosis/fit/joint_departure.hpp"
#include "proofmass/assess/diagnosis/record/term_space.hpp"
#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/numeric/linear/least_squares.hpp"

namespace proofmass {
namespace {

constexpr double kUnlikelyTerm = 1e-6;   // of each term, or set of terms, of a record that has none of them
constexpr double kLeastTermLeft = 1e-6;  // of a regressor's square: less lies within the terms asked for
constexpr std::size_t kLeastDofBeside = 3;
constexpr double kLeastErrors = 4.0;  // of a term beside the other missing ones, to be named

// Terms that were not asked for and that the rows can tell apart, with what of their regressors is beyond
// those that were.
struct Candidates {
  TermList terms;
  std::vector<std::vector<double>> beyond;
};

// Those of the terms that were not asked for and that the rows tell apart from those that were.
TermList identifiable_beside(const Identification& result, const TermList& terms, const Dataset& record) {
  TermList asked;
  for (const Coefficient& c : result.coefficients) asked.push_back(c.term);
  TermList all(asked);
  all.insert(all.end(), terms.begin(), terms.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  TermList others = analyse_identifiability(record, all).identified;
  std::erase_if(others,
                [&asked](Term term) { return std::find(asked.begin(), asked.end(), term) != asked.end(); });
  return others;
}

Candidates candidates_of(const FittedRows& rows, const Identification& result, const TermList& terms) {
  Candidates candidates;
  const TermList wanted = identifiable_beside(result, terms, rows.record());
  std::vector<std::vector<double>> regressors = regressor_columns(rows.record(), wanted);
  for (const std::size_t k : columns_beyond(rows, regressors, kLeastTermLeft).kept) {
    if (candidates.terms.size() + kLeastDofBeside >= rows.dof()) break;
    candidates.terms.push_back(wanted[k]);
    candidates.beyond.push_back(rows.beyond_terms(std::move(regressors[k])));
  }
  return candidates;
}

struct Missing {
  TermList terms;
  double errors = 0.0;  // of the first
  Matrix columns;
  double left = 0.0;  // residual standard deviation with the terms added
};

// Leaves out the least significant candidate until all are significant beside each other. Removing one from a
// least squares fit changes the others as the covariance says.
Missing significant_of(const FittedRows& rows, const Candidates& candidates) {
  Matrix design(rows.rows(), candidates.terms.size());
  for (std::size_t c = 0; c < design.columns(); ++c)
    std::copy(candidates.beyond[c].begin(), candidates.beyond[c].end(), design.column(c).begin());
  LeastSquaresFit fit = solve_least_squares(design, rows.residuals());
  std::vector<std::size_t> left(candidates.terms.size());
  for (std::size_t c = 0; c < left.size(); ++c) left[c] = c;
  const double floor = static_cast<double>(rows.rows()) * rows.rounding() * rows.rounding();
  double sd = 0.0;
  const auto errors = [&](std::size_t c) {
    return std::abs(fit.coefficients[c]) / (sd * std::sqrt(fit.unscaled_covariance(c, c)));
  };
  for (;;) {
    sd = std::sqrt(std::max(fit.rss, floor) / static_cast<double>(rows.dof() - left.size()));
    std::sort(left.begin(), left.end(), [&](std::size_t a, std::size_t b) { return errors(a) > errors(b); });
    const std::size_t least = left.back();
    if (left.size() == 1 || errors(least) > kLeastErrors) break;
    left.pop_back();
    const double variance = fit.unscaled_covariance(least, least);
    const double value = fit.coefficients[least];
    fit.rss += value * value / variance;
    Matrix& covariance = fit.unscaled_covariance;
    for (const std::size_t a : left) {
      fit.coefficients[a] -= covariance(a, least) / variance * value;
      for (const std::size_t b : left)
        covariance(a, b) -= covariance(a, least) * covariance(b, least) / variance;
    }
  }
  Missing missing{.terms = {}, .errors = errors(left.front()), .columns = {}, .left = sd};
  std::vector<std::vector<double>> columns;
  for (const std::size_t c : left) {
    missing.terms.push_back(candidates.terms[c]);
    columns.push_back(candidates.beyond[c]);
  }
  missing.columns = columns_beyond(rows, columns, 0.0).orthonormal;
  return missing;
}

bool is_significant(const FittedRows& rows, const Candidates& candidates) {
  const bool one = std::any_of(candidates.beyond.begin(), candidates.beyond.end(),
                               [&rows](const std::vector<double>& values) {
                                 return rows.departure(values).probability < kUnlikelyTerm;
                               });
  if (one) return true;
  const Matrix together = columns_beyond(rows, candidates.beyond, kLeastTermLeft).orthonormal;
  return joint_probability(rows, together) < kUnlikelyTerm;
}

}  // namespace

bool takes_terms_as_given(const Identification& result) {
  return !result.network && !std::holds_alternative<GmdhDetails>(result.details);
}

std::optional<ShortModel> find_short_model(const FittedRows& rows, const Identification& result) {
  if (!takes_terms_as_given(result)) return std::nullopt;
  std::optional<Missing> missing;
  for (const TermList& terms : std::array{quadratic_terms(), paper_terms(), full_terms()}) {
    const Candidates candidates = candidates_of(rows, result, terms);
    if (candidates.terms.empty() || !(missing || is_significant(rows, candidates))) continue;
    Missing found = significant_of(rows, candidates);
    if (!missing || found.left < missing->left) missing = std::move(found);
  }
  if (!missing) return std::nullopt;
  const Unit& unit = rows.record().output_unit;
  const double before = rows.standard_deviation();
  Finding finding{.code = Code::model_too_short,
                  .severity = Severity::warning,
                  .terms = missing->terms,
                  .figures = {{"count", missing->terms.size()},
                              {"errors", missing->errors},
                              {"before", before / std::abs(unit.to_canonical)},
                              {"after", missing->left / std::abs(unit.to_canonical)},
                              {"unit", unit.symbol}}};
  return ShortModel{.finding = std::move(finding), .columns = std::move(missing->columns)};
}

}  // namespace proofmass
