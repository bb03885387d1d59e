// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/regression/robust_loss.hpp"

#include <algorithm>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

namespace proofmass {
namespace {

constexpr double kNormalQuartile = 0.6744897501960817;
constexpr int kBracketings = 60;

// The root of a decreasing function between two positive bounds, to the last bits. When the root is outside,
// the nearer bound.
template <typename Function>
double decreasing_root(const Function& function, double low, double high) {
  const double at_low = function(low);
  if (!(at_low > 0.0)) return low;
  const double at_high = function(high);
  if (!(at_high < 0.0)) return high;
  std::uintmax_t evaluations = 200;
  const auto [left, right] = boost::math::tools::toms748_solve(
      function, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(52), evaluations);
  return 0.5 * (left + right);
}

double student_scale(std::span<const double> residuals, double guess, double dof) {
  const auto excess = [&](double scale) {
    double sum = 0.0;
    for (const double r : residuals) {
      const double square = (r / scale) * (r / scale);
      sum += std::isfinite(square) ? (dof + 1.0) * square / (dof + square) : dof + 1.0;
    }
    return sum / static_cast<double>(residuals.size()) - 1.0;
  };
  double low = guess;
  double high = guess;
  for (int k = 0; k < kBracketings && excess(low) <= 0.0; ++k) low *= 0.25;
  for (int k = 0; k < kBracketings && excess(high) >= 0.0; ++k) high *= 4.0;
  return decreasing_root(excess, low, high);
}

// Derivative of the log-likelihood per row by the degrees of freedom, times two.
double dof_score(std::span<const double> residuals, double scale, double dof) {
  double sum = 0.0;
  for (const double r : residuals) {
    const double u = r / scale;
    const double weight = (dof + 1.0) / (dof + u * u);
    sum += std::log(weight) - weight;
  }
  using boost::math::digamma;
  return digamma(0.5 * (dof + 1.0)) - digamma(0.5 * dof) - std::log((dof + 1.0) / dof) + 1.0 +
         sum / static_cast<double>(residuals.size());
}

}  // namespace

double RobustLoss::weight(double u) const noexcept {
  const double size = std::abs(u);
  switch (kind) {
    case LossKind::huber:
      return size <= tuning ? 1.0 : tuning / size;
    case LossKind::bisquare: {
      const double part = size / tuning;
      return part < 1.0 ? (1.0 - part * part) * (1.0 - part * part) : 0.0;
    }
    case LossKind::student:
      return (tuning + 1.0) / (tuning + u * u);
  }
  return 1.0;
}

double RobustLoss::slope(double u) const noexcept {
  const double size = std::abs(u);
  switch (kind) {
    case LossKind::huber:
      return size <= tuning ? 1.0 : 0.0;
    case LossKind::bisquare: {
      const double part = (size / tuning) * (size / tuning);
      return part < 1.0 ? (1.0 - part) * (1.0 - 5.0 * part) : 0.0;
    }
    case LossKind::student: {
      const double sum = tuning + u * u;
      return (tuning + 1.0) * (tuning - u * u) / (sum * sum);
    }
  }
  return 1.0;
}

double default_tuning(LossKind kind) noexcept {
  switch (kind) {
    case LossKind::huber:
      return kHuberTuning;
    case LossKind::bisquare:
      return kBisquareTuning;
    case LossKind::student:
      return kStudentDof;
  }
  return 0.0;
}

double median_scale(std::span<const double> residuals, std::size_t fitted) {
  std::vector<double> sizes;
  sizes.reserve(residuals.size());
  for (const double r : residuals) sizes.push_back(std::abs(r));
  if (sizes.empty()) return 0.0;
  std::sort(sizes.begin(), sizes.end());
  const std::size_t first = std::min(fitted, sizes.size() - 1);
  const std::size_t count = sizes.size() - first;
  const double median = 0.5 * (sizes[first + (count - 1) / 2] + sizes[first + count / 2]);
  return median / kNormalQuartile;
}

StudentScale fit_student(std::span<const double> residuals, double guess, double dof) {
  if (dof > 0.0) return {.scale = student_scale(residuals, guess, dof), .dof = dof};
  const auto score = [&](double trial) {
    return dof_score(residuals, student_scale(residuals, guess, trial), trial);
  };
  const double best = decreasing_root(score, kLeastStudentDof, kMostStudentDof);
  return {.scale = student_scale(residuals, guess, best), .dof = best};
}

}  // namespace proofmass
