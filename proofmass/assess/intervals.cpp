// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/intervals.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

namespace proofmass {
namespace {

using StudentT = boost::math::students_t_distribution<double>;

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

void add_intervals(Identification& result) {
  const auto dof = result.diagnostics.dof;
  if (dof && *dof == 0) return;
  const StudentT distribution(dof ? static_cast<double>(*dof) : std::numeric_limits<double>::infinity());
  const double factor = boost::math::quantile(distribution, 0.975);
  for (Coefficient& coefficient : result.coefficients) {
    if (coefficient.identified && coefficient.standard_error) add_interval(coefficient, distribution, factor);
  }
}

}  // namespace proofmass
