// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/optimise/termination.hpp"

namespace proofmass {

// A sum of squares r(x)ᵀr(x) with a current point and a trial point, so that nothing is computed twice.
class SumOfSquares {
 public:
  SumOfSquares() = default;
  SumOfSquares(const SumOfSquares&) = delete;
  SumOfSquares& operator=(const SumOfSquares&) = delete;
  virtual ~SumOfSquares() = default;

  [[nodiscard]] virtual std::size_t parameters() const = 0;
  // Returns r(x)ᵀr(x); x becomes the trial point.
  virtual double evaluate(std::span<const double> x) = 0;
  // The trial point becomes the current one.
  virtual void accept() = 0;
  // The lower triangle of JᵀJ, and Jᵀr, at the current point, J = dr/dx.
  virtual void linearise(Matrix& normal, std::span<double> gradient) = 0;
  // Jᵀ d²r/dt² along x + t * direction at the current point, after linearise. Returns false when the problem
  // cannot compute it.
  virtual bool curvature(std::span<const double> direction, std::span<double> result);
};

// Residuals r(x) with a Jacobian J = dr/dx that fits into memory. Minimised by QR of J, to the last digits of
// the residuals. At least as many rows as parameters.
class ResidualProblem {
 public:
  ResidualProblem() = default;
  ResidualProblem(const ResidualProblem&) = delete;
  ResidualProblem& operator=(const ResidualProblem&) = delete;
  virtual ~ResidualProblem() = default;

  [[nodiscard]] virtual std::size_t rows() const = 0;
  // One per row. Values that are not finite mark a point where the problem is not defined.
  virtual void residuals(std::span<const double> x, std::span<double> result) = 0;
  // rows() x parameters.
  virtual void jacobian(std::span<const double> x, Matrix& result) = 0;
};

enum class Damping {
  multiplicative,  // mu times a factor after each success and failure (Hagan & Menhaj 1994; trainlm)
  gain_ratio,      // mu by the ratio of actual to predicted reduction (Nielsen 1999)
};

struct LevenbergMarquardtOptions {
  std::size_t iterations = 1000;
  Damping damping = Damping::gain_ratio;
  bool scaled = true;  // damp by the running maximum of diag(JᵀJ) (Moré 1978) instead of the identity
  double scale_memory = 1.0;           // fraction of that maximum kept per iteration; below 1 it fades
  bool geodesic_acceleration = false;  // second-order correction of the step (Transtrum & Sethna 2012)
  double mu = 1e-3;                    // initial damping
  double decrease = 0.1;               // factors of the multiplicative rule
  double increase = 10.0;
  double mu_max = 1e10;           // damping beyond this ends the iteration
  double minimum_gradient = 0.0;  // ends when |Jᵀr| falls to this
  double target = 0.0;            // ends when the sum of squares falls to this
  std::size_t stall_window =
      0;  // ends when the sum of squares fell by less than stall_reduction of itself over
  double stall_reduction = 1e-6;  // so many iterations; 0: never
  double orthogonality = 0.0;     // ends when no column of J has a larger cosine with r; 0: never
  // Maximum number of Gauss-Newton steps after the last step whose reduction can be measured; they continue
  // as long as they shrink. The sum of squares locates a minimum only to the root of its rounding error; its
  // gradient is more accurate.
  std::size_t polishing_steps = 0;
};

struct LevenbergMarquardtResult {
  std::vector<double> point;    // the best found
  double sum_of_squares = 0.0;  // its sum of squares
  std::size_t iterations = 0;   // accepted steps
  std::size_t evaluations = 0;  // evaluations of the sum of squares
  std::vector<double> history;  // sum of squares at the start and after each accepted step
  double mu = 0.0;              // final damping, for continuing the iteration
  Termination termination;
};

// Called after each accepted step; returns false to stop.
using LevenbergMarquardtObserver =
    std::function<bool(std::size_t iteration, std::span<const double> point, double)>;

// Minimises the sum of squares from `start` (Levenberg 1944, Marquardt 1963). The sum never grows, except in
// polishing, where rounding may raise it by at most a thousandth. A start whose sum of squares is not finite
// ends at once with cause stalled.
[[nodiscard]] LevenbergMarquardtResult minimise(SumOfSquares& problem, std::span<const double> start,
                                                const LevenbergMarquardtOptions& options,
                                                const LevenbergMarquardtObserver& observer = {});

// The same by QR of the Jacobian (Moré 1978). Throws std::invalid_argument when there are fewer rows than
// parameters.
[[nodiscard]] LevenbergMarquardtResult minimise(ResidualProblem& problem, std::span<const double> start,
                                                const LevenbergMarquardtOptions& options,
                                                const LevenbergMarquardtObserver& observer = {});

}  // namespace proofmass
