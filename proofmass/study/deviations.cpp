// SPDX-License-Identifier: Apache-2.0
#include "proofmass/study/deviations.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace proofmass {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

const Coefficient* find_identified(const Contestant& contestant, Term term) {
  for (const Coefficient& c : contestant.runs.front().identification.coefficients)
    if (c.term == term && c.identified) return &c;
  return nullptr;
}

bool has_errors(const Contestant& contestant) {
  const auto& all = contestant.runs.front().identification.coefficients;
  return std::any_of(all.begin(), all.end(),
                     [](const Coefficient& c) { return c.identified && c.standard_error; });
}

std::vector<Term> identified_terms_of(const Comparison& comparison) {
  std::vector<Term> terms;
  for (const Contestant& contestant : comparison.contestants) {
    for (const Coefficient& c : contestant.runs.front().identification.coefficients)
      if (c.identified) terms.push_back(c.term);
  }
  std::sort(terms.begin(), terms.end());
  terms.erase(std::unique(terms.begin(), terms.end()), terms.end());
  return terms;
}

double deviation(const Coefficient* coefficient, double from, const std::optional<double>& error) {
  if (coefficient == nullptr || !error || !(*error > 0.0)) return kNone;
  return (coefficient->value - from) / *error;
}

double half_width(const Coefficient* coefficient) {
  if (coefficient == nullptr || !coefficient->ci95 || !(coefficient->standard_error > 0.0)) return kNone;
  return 0.5 * (coefficient->ci95->high - coefficient->ci95->low) / *coefficient->standard_error;
}

double median_of(std::span<const double> sorted) {
  const std::size_t n = sorted.size();
  return n % 2 == 1 ? sorted[n / 2] : 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]);
}

}  // namespace

Deviations deviations(const Comparison& comparison) {
  Deviations made{
      .from_truth = comparison.truth.has_value(), .reference = {}, .terms = identified_terms_of(comparison)};
  const auto reference =
      std::find_if(comparison.contestants.begin(), comparison.contestants.end(), has_errors);
  if (!made.from_truth) {
    if (reference == comparison.contestants.end()) return made;
    made.reference = reference->method;
  }
  for (const Contestant& contestant : comparison.contestants) {
    if (contestant.method == made.reference) continue;
    std::vector<double> row;
    std::vector<double> half_widths;
    for (const Term term : made.terms) {
      const Coefficient* const own = find_identified(contestant, term);
      half_widths.push_back(half_width(own));
      if (made.from_truth) {
        const auto error = own != nullptr ? own->standard_error : std::nullopt;
        row.push_back(deviation(own, comparison.truth->coefficient(term), error));
      } else {
        const Coefficient* const other = find_identified(*reference, term);
        row.push_back(other == nullptr ? kNone : deviation(own, other->value, other->standard_error));
      }
    }
    made.methods.push_back(contestant.method);
    made.in_errors.push_back(std::move(row));
    made.half_widths.push_back(std::move(half_widths));
  }
  return made;
}

FiveNumbers five_numbers(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = (values.size() + 1) / 2;
  const std::span<const double> all(values);
  FiveNumbers made{
      .lower = median_of(all.first(half)), .median = median_of(all), .upper = median_of(all.last(half))};
  constexpr double kReach = 1.5;
  const double reach = kReach * (made.upper - made.lower);
  made.low = made.high = made.median;
  for (const double v : values) {
    if (v < made.lower - reach || v > made.upper + reach) {
      made.beyond.push_back(v);
    } else {
      made.low = std::min(made.low, v);
      made.high = std::max(made.high, v);
    }
  }
  return made;
}

}  // namespace proofmass
