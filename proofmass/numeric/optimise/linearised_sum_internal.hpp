// SPDX-License-Identifier: Apache-2.0
// The interface of a sum of squares to the Levenberg-Marquardt iteration, independent of how its equations
// are solved.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "proofmass/numeric/optimise/levenberg_marquardt.hpp"

namespace proofmass {

// A sum of squares with its linearisation at the current point.
class LinearisedSum {
 public:
  LinearisedSum() = default;
  LinearisedSum(const LinearisedSum&) = delete;
  LinearisedSum& operator=(const LinearisedSum&) = delete;
  virtual ~LinearisedSum() = default;

  // The sum of squares at x, which becomes the trial point.
  virtual double evaluate(const Eigen::VectorXd& x) = 0;
  // The trial point becomes the current one.
  virtual void accept() = 0;
  // Computes gradient and factors at the current point.
  virtual void linearise() = 0;
  [[nodiscard]] virtual const Eigen::VectorXd& gradient() const = 0;  // Jᵀr
  [[nodiscard]] virtual Eigen::VectorXd diagonal() const = 0;         // of JᵀJ
  // The least damping of a parameter, as a fraction of the largest scale, with which the factors are still
  // accurate.
  [[nodiscard]] virtual double least_scale() const noexcept = 0;
  // Factors JᵀJ + diag(damping). False when this fails.
  virtual bool factor(const Eigen::VectorXd& damping) = 0;
  // -(JᵀJ + damping)⁻¹ Jᵀr, from the last factors.
  [[nodiscard]] virtual Eigen::VectorXd velocity() = 0;
  // -(JᵀJ + damping)⁻¹ Jᵀ d²r/dt² along x + t * velocity. Empty when the problem cannot compute it.
  [[nodiscard]] virtual std::optional<Eigen::VectorXd> acceleration(const Eigen::VectorXd& velocity) = 0;
  // The reduction of the linearised sum of squares along the velocity, from the last factors.
  [[nodiscard]] virtual double predicted_reduction(const Eigen::VectorXd& velocity) const = 0;
};

// By Cholesky factors of JᵀJ, which the problem sums itself: half the digits, but no memory for J.
[[nodiscard]] std::unique_ptr<LinearisedSum> by_normal_equations(SumOfSquares& problem);

// By Householder QR of J, then of its triangle over the root of the damping (Moré 1978): all digits.
[[nodiscard]] std::unique_ptr<LinearisedSum> by_triangular_factor(ResidualProblem& problem,
                                                                  std::span<const double> start);

}  // namespace proofmass
