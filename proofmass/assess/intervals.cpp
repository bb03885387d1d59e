// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/intervals.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

namespace proofmass {
namespace {

using StudentT = boost::math::students_t_distribution<double>;

StudentT distribution_of(const Identification& result) {
  const Diagnostics& diagnostics = result.diagnostics;
  const std::size_t dof = diagnostics.interval_dof.value_or(diagnostics.dof.value_or(0));
  return StudentT(dof > 0 ? static_cast<double>(dof) : std::numeric_limits<double>::infinity());
}

void add_interval(Coefficient& coefficient, const StudentT& distribution, double half_width_factor) {
  const double error = *coefficient.standard_error;
  const double half_width = half_width_factor * error;
  coefficient.ci95 = Interval{.low = coefficient.value - half_width, .high = coefficient.value + half_width};
  coefficient.t.reset();
  coefficient.p.reset();
  const double t = coefficient.value / error;
  if (!std::isfinite(t)) return;
  coefficient.t = t;
  coefficient.p = 2.0 * boost::math::cdf(boost::math::complement(distribution, std::abs(t)));
}

}  // namespace

double coverage_factor(const Identification& result) {
  return boost::math::quantile(distribution_of(result), 0.975);
}

void add_intervals(Identification& result) {
  if (result.diagnostics.dof && *result.diagnostics.dof == 0) return;
  const StudentT distribution = distribution_of(result);
  const double factor = coverage_factor(result);
  for (Coefficient& coefficient : result.coefficients) {
    if (coefficient.identified && coefficient.standard_error) add_interval(coefficient, distribution, factor);
  }
}

}  // namespace proofmass
