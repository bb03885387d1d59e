// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/identification.hpp"

#include <algorithm>
#include <cmath>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

// Rows and columns of the covariance belong to the identified coefficients, in their order.
class Covariance {
 public:
  explicit Covariance(const Identification& result) : values_(result.covariance) {
    for (const Coefficient& c : result.coefficients) {
      if (c.identified) terms_.push_back(c.term);
    }
  }
  [[nodiscard]] bool known() const {
    return !terms_.empty() && values_.size() == terms_.size() * terms_.size();
  }
  [[nodiscard]] double of(Term a, Term b) const { return values_[index(a) * terms_.size() + index(b)]; }

 private:
  [[nodiscard]] std::size_t index(Term term) const {
    return static_cast<std::size_t>(std::find(terms_.begin(), terms_.end(), term) - terms_.begin());
  }
  const std::vector<double>& values_;
  TermList terms_;
};

// Half the width of a coefficient's interval over its standard error. Empty when there is no interval.
std::optional<double> coverage_factor(const Coefficient& c) {
  if (!c.ci95 || !c.standard_error || !(*c.standard_error > 0.0)) return std::nullopt;
  return 0.5 * (c.ci95->high - c.ci95->low) / *c.standard_error;
}

// Standard error of x/Ki to first order. Rounding can make a variance near zero negative; it counts as zero.
double ratio_error(const Covariance& covariance, Term term, double ratio, double ki) {
  const double variance = covariance.of(term, term) - 2.0 * ratio * covariance.of(term, Term::Ki) +
                          ratio * ratio * covariance.of(Term::Ki, Term::Ki);
  return std::sqrt(std::max(0.0, variance)) / std::abs(ki);
}

Coefficient referred(const Coefficient& raw, double ki, const Covariance& covariance) {
  Coefficient c;
  c.term = raw.term;
  c.vif = raw.vif;
  c.identified = raw.identified;
  c.reason = raw.reason;
  if (!raw.identified) return c;
  if (raw.term == Term::Ki) {
    c.value = 1.0;
    return c;
  }
  c.value = raw.value / ki;
  if (!covariance.known()) return c;
  const double error = ratio_error(covariance, raw.term, c.value, ki);
  c.standard_error = error;
  if (const auto factor = coverage_factor(raw)) {
    c.ci95 = Interval{.low = c.value - *factor * error, .high = c.value + *factor * error};
  }
  if (error > 0.0) c.t = c.value / error;
  return c;
}

}  // namespace

const Coefficient& Identification::find(Term term) const {
  for (const Coefficient& c : coefficients) {
    if (c.term == term) return c;
  }
  throw usage_error(message("the term {} was not among those to identify", name(term)));
}

StaticModel Identification::static_model() const {
  StaticModel identified;
  for (const Coefficient& c : coefficients) {
    if (!c.identified) continue;
    identified.terms.push_back(c.term);
    identified.coefficients.push_back(c.value);
  }
  return identified;
}

std::vector<Coefficient> referred_to_input(const Identification& result) {
  const double ki = result.static_model().coefficient(Term::Ki);
  if (ki == 0.0) return {};
  for (const Coefficient& c : result.coefficients) {
    // First-order propagation through 1 / Ki is valid only when Ki is many standard errors away from zero.
    constexpr double kClear = 5.0;
    if (c.term == Term::Ki && c.standard_error && std::abs(ki) < kClear * *c.standard_error) return {};
  }
  const Covariance covariance(result);
  std::vector<Coefficient> list;
  list.reserve(result.coefficients.size());
  for (const Coefficient& c : result.coefficients) list.push_back(referred(c, ki, covariance));
  return list;
}

}  // namespace proofmass
