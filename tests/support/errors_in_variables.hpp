// SPDX-License-Identifier: Apache-2.0
// Errors of repeated identifications from a plan with input noise, compared with the best possible ones.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "proofmass/assess/efficient_bound.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "proofmass/study/truth.hpp"

namespace proofmass::test {

// Least possible standard deviations of the coefficients of an unbiased estimate from the rows. The true
// accelerations are known only through their noise. The information is, to first order in the noise, the sum
// of phi phiᵀ / (sigma_E² + sum of (dE/dA)² sigma_A²) at the truth.
inline std::vector<double> errors_in_variables_bound(const SimulationPlan& plan, const TermList& terms) {
  SimulationPlan without = plan;
  without.input_sigma = {};
  const Dataset exact = simulate(without);
  return efficient_errors(exact, terms, row_information(plan, exact));
}

class ErrorTally {
 public:
  ErrorTally(const SimulationPlan& plan, const TermList& terms)
      : truth_(plan.truth()),
        terms_(terms),
        bound_(errors_in_variables_bound(plan, terms)),
        sum_(terms.size()) {}

  void add(const Identification& result) {
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      const Coefficient& c = result.coefficients.at(k);
      const double error = c.value - truth_.coefficient(c.term);
      sum_[k] += error;
      over_bound_ += std::pow(error / bound_[k], 2);
      over_standard_error_ += std::pow(error / *c.standard_error, 2);
    }
    ++repeats_;
  }

  // Mean error over the standard error of that mean, the latter from the bound.
  [[nodiscard]] double bias_in_standard_errors(Term term) const {
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      if (terms_[k] == term) return sum_[k] / (bound_[k] * std::sqrt(static_cast<double>(repeats_)));
    }
    return std::nan("");
  }
  // Root mean square over terms and repeats.
  [[nodiscard]] double over_bound() const { return std::sqrt(over_bound_ / count()); }
  [[nodiscard]] double over_standard_error() const { return std::sqrt(over_standard_error_ / count()); }

 private:
  [[nodiscard]] double count() const { return static_cast<double>(repeats_ * terms_.size()); }
  StaticModel truth_;
  TermList terms_;
  std::vector<double> bound_, sum_;
  double over_bound_ = 0.0, over_standard_error_ = 0.0;
  std::size_t repeats_ = 0;
};

}  // namespace proofmass::test
