// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace proofmass {

enum class LossKind { huber, bisquare, student };

// Constants for 95 % efficiency on normal noise: Huber's k (Ann. Math. Statist. 35, 1964) and Tukey's c
// (Beaton & Tukey, Technometrics 16, 1974).
inline constexpr double kHuberTuning = 1.345;
inline constexpr double kBisquareTuning = 4.685;
inline constexpr double kStudentDof = 4.0;  // degrees of freedom where they are not estimated

// A loss of the scaled residual u, given by its derivative psi(u) = weight(u) * u. Tuning is Huber's k,
// Tukey's c, or Student's degrees of freedom.
struct RobustLoss {
  LossKind kind = LossKind::huber;
  double tuning = kHuberTuning;
  [[nodiscard]] double weight(double u) const noexcept;  // at most about 1, 1 at most small residuals
  [[nodiscard]] double slope(double u) const noexcept;   // derivative of psi
};

// The constant above for the loss.
[[nodiscard]] double default_tuning(LossKind kind) noexcept;

// Robust scale, equal to the standard deviation for normal residuals: the median of |r| without the `fitted`
// smallest, divided by 0.6745. A fit with that many coefficients can make as many residuals zero. Zero for no
// rows.
[[nodiscard]] double median_scale(std::span<const double> residuals, std::size_t fitted);

// Scale and degrees of freedom of a Student t distribution about zero.
struct StudentScale {
  double scale = 0.0;
  double dof = 0.0;
};

inline constexpr double kLeastStudentDof = 1.0;
inline constexpr double kMostStudentDof = 200.0;  // practically normal

// Maximum likelihood of scale and degrees of freedom (within the two bounds above), or of the scale alone
// when `dof` is above zero (Lange, Little & Taylor, JASA 84, 1989). `guess` is a rough scale above zero.
[[nodiscard]] StudentScale fit_student(std::span<const double> residuals, double guess, double dof = 0.0);

}  // namespace proofmass
