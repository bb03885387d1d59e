// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/linear/regression_rows.hpp"
#include "proofmass/numeric/linear/weighted_least_squares.hpp"
#include "proofmass/numeric/optimise/termination.hpp"

namespace proofmass {

struct GrowingVarianceOptions {
  std::size_t iterations = 50;  // rounds of refitting coefficients and variances, at most
  double tolerance = 1e-12;     // ends when the fraction of the growing part moves by no more than this
};

// A linear regression whose residual variance is base + slope * growth[row].
struct GrowingVarianceFit {
  WeightedFit fit;        // with weights mean variance / variance
  double base = 0.0;      // unit of y squared, not negative
  double slope = 0.0;     // unit of y squared over growth's unit, not negative
  double variance = 0.0;  // weighted RSS / (rows - columns), the factor of fit.unscaled_covariance
  std::size_t iterations = 0;
  Termination termination;
};

// Restricted maximum likelihood for base, slope >= 0 (Patterson & Thompson, Biometrika 58, 1971) by iterated
// feasible generalised least squares. Two steps alternate: the coefficients with fixed variances, and the
// fraction of the growing part from the exact REML score with fixed residuals and leverages. The variance at
// growth 0 is kept above 1e-6 of the mean, so that no row gets an unbounded weight. `growth` is not negative,
// one value per row. When it does not vary, the slope is zero. A round makes a few passes over the rows and
// stores a few figures per row. Needs more rows than regressors. Throws std::invalid_argument as
// solve_weighted_least_squares does.
[[nodiscard]] GrowingVarianceFit fit_growing_variance(const RegressionRows& rows,
                                                      std::span<const double> growth,
                                                      const GrowingVarianceOptions& options = {});
[[nodiscard]] GrowingVarianceFit fit_growing_variance(const Matrix& design, std::span<const double> y,
                                                      std::span<const double> growth,
                                                      const GrowingVarianceOptions& options = {});

}  // namespace proofmass
