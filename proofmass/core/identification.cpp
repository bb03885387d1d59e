// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/identification.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "proofmass/core/error.hpp"

namespace proofmass {
namespace {

constexpr std::array<std::string_view, 3> kCovarianceKinds{"model", "hc3", "mount"};

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

std::string_view to_string(CovarianceKind kind) noexcept {
  return kCovarianceKinds[static_cast<std::size_t>(kind)];
}

std::optional<CovarianceKind> find_covariance_kind(std::string_view name) noexcept {
  const auto* const found = std::find(kCovarianceKinds.begin(), kCovarianceKinds.end(), name);
  if (found == kCovarianceKinds.end()) return std::nullopt;
  return static_cast<CovarianceKind>(found - kCovarianceKinds.begin());
}

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

std::vector<double> correlations_of(const Identification& result) {
  const auto n =
      static_cast<std::size_t>(std::count_if(result.coefficients.begin(), result.coefficients.end(),
                                             [](const Coefficient& c) { return c.identified; }));
  if (n == 0 || result.covariance.size() != n * n) return {};
  std::vector<double> correlations(n * n, 0.0);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      const double scale = std::sqrt(result.covariance[a * n + a] * result.covariance[b * n + b]);
      correlations[a * n + b] = a == b ? 1.0 : scale > 0.0 ? result.covariance[a * n + b] / scale : 0.0;
    }
  }
  return correlations;
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
