// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/residuals/nonlinearity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "proofmass/assess/intervals.hpp"

namespace proofmass {
namespace {

constexpr std::array kTermsOfInput{Term::Kii, Term::Koq, Term::Kiii};

std::optional<Interval> range_of_input(const Identification& result) {
  for (const auto& [axis, range] : result.input_range)
    if (axis == Axis::input && range.high > range.low) return range;
  return std::nullopt;
}

// The identified terms of Ai alone, each with its place among the identified coefficients.
struct CurvedTerm {
  Term term;
  double value;
  std::size_t place;
};
std::vector<CurvedTerm> curved_terms(const Identification& result) {
  std::vector<CurvedTerm> found;
  std::size_t place = 0;
  for (const Coefficient& c : result.coefficients) {
    if (!c.identified) continue;
    if (std::find(kTermsOfInput.begin(), kTermsOfInput.end(), c.term) != kTermsOfInput.end())
      found.push_back({c.term, c.value, place});
    ++place;
  }
  return found;
}

std::size_t identified_count(const Identification& result) {
  return static_cast<std::size_t>(std::count_if(result.coefficients.begin(), result.coefficients.end(),
                                                [](const Coefficient& c) { return c.identified; }));
}

}  // namespace

Nonlinearity nonlinearity_of(const Identification& result) {
  constexpr std::size_t kPlaces = 121;
  const std::vector<CurvedTerm> terms = curved_terms(result);
  const std::optional<Interval> range = range_of_input(result);
  Nonlinearity made;
  if (terms.empty() || !range) return made;
  for (const CurvedTerm& one : terms) made.terms.push_back(one.term);
  const std::size_t n = identified_count(result);
  const bool has_covariance = result.covariance.size() == n * n;
  const double coverage = coverage_factor(result);
  for (std::size_t k = 0; k < kPlaces; ++k) {
    const double at = range->low + (range->high - range->low) * static_cast<double>(k) / (kPlaces - 1);
    double value = 0.0;
    double variance = 0.0;
    for (const CurvedTerm& a : terms) {
      const double xa = regressor(a.term, {.i = at});
      value += a.value * xa;
      if (!has_covariance) continue;
      for (const CurvedTerm& b : terms)
        variance += xa * regressor(b.term, {.i = at}) * result.covariance[a.place * n + b.place];
    }
    made.input.push_back(at);
    made.value.push_back(value);
    if (has_covariance) made.half_width.push_back(coverage * std::sqrt(std::max(variance, 0.0)));
  }
  return made;
}

}  // namespace proofmass
