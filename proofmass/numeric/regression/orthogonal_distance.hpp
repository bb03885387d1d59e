// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/optimise/termination.hpp"
#include "proofmass/numeric/regression/surface.hpp"

namespace proofmass {

// Observations of a surface: rows of inputs and output, with independent errors.
struct SurfaceObservations {
  std::vector<std::span<const double>> inputs;  // one column per input
  // Standard deviations of the inputs, one column per input. An empty column, or a zero in it, means exact.
  std::vector<std::span<const double>> input_sigma;
  std::span<const double> output;
  std::span<const double> output_sigma;  // above zero
};

struct OrthogonalDistanceOptions {
  std::size_t iterations = 200;  // at most
  // Ends when a step, offsets included, is shorter than this in units of standard deviations.
  double tolerance = 1e-10;
};

// Called after each iteration with the weighted sum of squares; returns false to stop.
using OrthogonalDistanceObserver = std::function<bool(std::size_t iteration, double sum_of_squares)>;

struct OrthogonalDistanceFit {
  std::vector<double> parameters;
  // Inverse of the normal matrix of the parameters with the offsets eliminated, sum of phi phiᵀ / v. It is
  // the covariance when the given standard deviations are correct (cov_beta of ODRPACK and SciPy). When only
  // their ratios are correct, multiply it by sum_of_squares / dof.
  Matrix unscaled_covariance;
  double sum_of_squares = 0.0;  // of output residuals and input offsets, each over its standard deviation
  std::size_t dof = 0;          // rows - parameters
  Matrix offsets;               // rows x inputs: estimated true input minus the observed one
  std::vector<double> history;  // sum of squares at the start and after each iteration
  std::size_t iterations = 0;
  Termination termination;
};

// Weighted orthogonal distance regression (Boggs, Byrd & Schnabel, SIAM J. Sci. Stat. Comput. 8, 1987). It
// minimises, over the parameters and the true inputs x + d of every row, the sum of (y - f(x + d;
// parameters))² / sigma_y² + sum of d² / sigma_x². Each row's d is eliminated in closed form, because its
// block of the normal matrix is diagonal plus rank one. An iteration then costs as much as one of weighted
// least squares, with weights 1/v, v = sigma_y² + sum of (df/dx)² sigma_x². Gauss-Newton, with
// Levenberg-Marquardt damping when a step fails. The result does not depend on the number of threads. Throws
// std::invalid_argument when the sizes of columns differ, a sigma is negative or not finite, one of
// output_sigma is not above zero, or there are fewer rows than parameters.
[[nodiscard]] OrthogonalDistanceFit fit_orthogonal_distance(const Surface& surface,
                                                            const SurfaceObservations& observed,
                                                            std::span<const double> start,
                                                            const OrthogonalDistanceOptions& options = {},
                                                            const OrthogonalDistanceObserver& observer = {});

}  // namespace proofmass
