// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/fit/short_model.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>
#include <vector>

namespace proofmass {
namespace {

constexpr double kUnlikelyTerm = 1e-6;   // of each term of a record that has none of them
constexpr double kLeastTermLeft = 1e-6;  // of a regressor's square: less lies within the terms asked for
constexpr std::size_t kMostNamed = 4;

bool takes_terms_as_given(const Identification& result) {
  return !result.network && !std::holds_alternative<GmdhDetails>(result.details);
}

struct Missing {
  Term term = Term::K0;
  double errors = 0.0;
};

}  // namespace

std::optional<Finding> find_short_model(const FittedRows& rows, const Identification& result) {
  if (!takes_terms_as_given(result)) return std::nullopt;
  std::vector<Missing> missing;
  for (const Term term : full_terms()) {
    const bool asked = std::any_of(result.coefficients.begin(), result.coefficients.end(),
                                   [term](const Coefficient& c) { return c.term == term; });
    if (asked) continue;
    std::vector<double> values(rows.rows());
    for (std::size_t row = 0; row < values.size(); ++row)
      values[row] = regressor(term, rows.record().at(row));
    const double before = sum_of_squares(values);
    const std::vector<double> beyond = rows.beyond_terms(std::move(values));
    if (!(sum_of_squares(beyond) > kLeastTermLeft * before)) continue;
    const Departure departure = rows.departure(beyond);
    if (departure.probability < kUnlikelyTerm) missing.push_back({term, std::abs(departure.errors)});
  }
  if (missing.empty()) return std::nullopt;
  std::stable_sort(missing.begin(), missing.end(),
                   [](const Missing& a, const Missing& b) { return a.errors > b.errors; });
  Finding finding{.code = Code::model_too_short,
                  .severity = Severity::warning,
                  .figures = {{"count", missing.size()}, {"errors", missing.front().errors}}};
  for (std::size_t k = 0; k < std::min(kMostNamed, missing.size()); ++k)
    finding.terms.push_back(missing[k].term);
  return finding;
}

}  // namespace proofmass
