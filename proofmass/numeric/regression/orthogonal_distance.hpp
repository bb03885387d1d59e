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

// What was observed of a surface: rows of inputs and output, all with independent errors.
struct SurfaceObservations {
  std::vector<std::span<const double>> inputs;  // one column an input
  // Standard deviations of the inputs, one column an input; an empty column, or a zero in it, means exact.
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
  // Inverse of the normal matrix of the parameters with the offsets eliminated, sum of phi phiᵀ / v: the
  // covariance when the standard deviations given are right (ODRPACK and SciPy call it cov_beta). Times
  // sum_of_squares / dof it is the covariance when only their ratios are.
  Matrix unscaled_covariance;
  double sum_of_squares = 0.0;  // of output residuals and input offsets, each over its standard deviation
  std::size_t dof = 0;          // rows - parameters
  // How many standard errors the surface's variation over the rows is from none, sqrt(sum of (f - mean)² /
  // v), and the parameters together from zero, |R p| with R'R the normal matrix.
  double variation = 0.0;
  double significance = 0.0;
  // Whether the parameters grew without end while the sum of squares tended to a limit: the surface turns
  // parallel to the output, where its scale no longer matters. Never called converged.
  bool runaway = false;
  Matrix offsets;               // rows x inputs: estimated true input minus the observed one
  std::vector<double> history;  // sum of squares at the start and after each iteration
  std::size_t iterations = 0;
  Termination termination;
};

// Weighted orthogonal distance regression: minimises, over the parameters and the true inputs x + d of every
// row, sum of (y - f(x + d; parameters))² / sigma_y² + sum of d² / sigma_x² (Boggs, Byrd & Schnabel, SIAM J.
// Sci. Stat. Comput. 8, 1987). Each row's d is eliminated in closed form — its block of the normal matrix is
// diagonal plus rank one — so that an iteration costs what one of weighted least squares does, with weights
// 1/v, v = sigma_y² + sum of (df/dx)² sigma_x². Gauss-Newton, damped by Levenberg and Marquardt when a step
// fails. Where the surface bends within a row's input sigmas, the row's d is found by secant steps and, at
// the solution, sought again from several starts, for it may have several local solutions. A sum of squares
// that stands still where the step left is far below one standard error is convergence, and the reason says
// so. The result does not depend on the number of threads. Throws std::invalid_argument when columns do not
// fit together, a sigma is negative or not finite, one of output_sigma is not above zero, or there are fewer
// rows than parameters.
[[nodiscard]] OrthogonalDistanceFit fit_orthogonal_distance(const Surface& surface,
                                                            const SurfaceObservations& observed,
                                                            std::span<const double> start,
                                                            const OrthogonalDistanceOptions& options = {},
                                                            const OrthogonalDistanceObserver& observer = {});

// From the first of several starts; and from all of them where that does not end at a finite minimum, or at
// one with a variation below ten, for an output that depends so weakly on the inputs leaves room for several
// minima. Returns
// the converged end with the least sum of squares, else the end from the first start. The reason of the
// ending says when another start was taken, and when the sum of squares is less still where the parameters
// run away.
[[nodiscard]] OrthogonalDistanceFit fit_orthogonal_distance_from(
    const Surface& surface, const SurfaceObservations& observed,
    const std::vector<std::vector<double>>& starts, const OrthogonalDistanceOptions& options = {},
    const OrthogonalDistanceObserver& observer = {});

}  // namespace proofmass
