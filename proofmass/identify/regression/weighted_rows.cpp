// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/regression/weighted_rows.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

// The weight that a row must be above to count.
double no_weight(std::span<const double> weights) {
  return kNoWeight * *std::max_element(weights.begin(), weights.end());
}

std::vector<std::size_t> rows_with_weight(std::span<const double> weights) {
  const double least = no_weight(weights);
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < weights.size(); ++row) {
    if (weights[row] > least) rows.push_back(row);
  }
  return rows;
}

Error weighted_refusal(const Dataset& data, Identifiability left, std::size_t rows) {
  TermList names;
  for (const Finding& finding : left.unidentified) names.push_back(finding.terms.front());
  return refusal(
      message("{}: the {} of {} rows that have weight cannot identify {}. Fit without them, ask for fewer "
              "terms, or look at the rows that have no weight",
              data.source, rows, data.rows(), join_names(names)),
      terms_remedies(left.identified), std::move(left.unidentified));
}

// An exact fit to as many rows as terms says nothing of its errors.
void require_spare_row(const Dataset& data, const Identifiability& left, std::size_t rows) {
  if (rows > left.identified.size()) return;
  throw refusal(
      message("{}: {} of {} rows {} weight beside the others, too few for {}; at least one "
              "more than the terms is needed: ask for fewer terms, or look at the rows that have no "
              "weight",
              data.source, rows, data.rows(), rows == 1 ? Message("has") : Message("have"),
              amount_of(left.identified.size(), "term", "terms")),
      {{"terms", ""}});
}

}  // namespace

std::size_t count_rows_with_weight(std::span<const double> weights) {
  const double least = no_weight(weights);
  return static_cast<std::size_t>(
      std::count_if(weights.begin(), weights.end(), [least](double weight) { return weight > least; }));
}

Identifiability require_identifiable_by_weight(const Dataset& data, const Identifiability& found,
                                               std::span<const double> weights, RankLossPolicy policy) {
  if (*std::min_element(weights.begin(), weights.end()) > no_weight(weights)) return found;
  const std::vector<std::size_t> rows = rows_with_weight(weights);
  Identifiability left = analyse_identifiability(data.select(rows), found.identified);
  if (left.unidentified.empty()) {
    require_spare_row(data, found, rows.size());
    return found;
  }
  for (Finding& finding : left.unidentified) {
    finding.figures.emplace_back("count", rows.size());
    finding.figures.emplace_back("total", data.rows());
  }
  if (policy == RankLossPolicy::refuse || left.identified.empty())
    throw weighted_refusal(data, std::move(left), rows.size());
  require_spare_row(data, left, rows.size());
  left.unidentified.insert(left.unidentified.end(), found.unidentified.begin(), found.unidentified.end());
  sort_by_term(left.unidentified);
  return left;
}

}  // namespace proofmass
