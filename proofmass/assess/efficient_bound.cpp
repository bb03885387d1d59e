// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/efficient_bound.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "proofmass/identify/model/design_matrix.hpp"
#include "proofmass/numeric/linear/weighted_least_squares.hpp"

namespace proofmass {
namespace {

struct Density {
  double value = 0.0;
  double slope = 0.0;
};

Density normal_density(double x) {
  const double density = std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi);
  return {.value = density, .slope = -x * density};
}

Density student_density(double x, double dof) {
  const double constant =
      std::exp(std::lgamma(0.5 * (dof + 1.0)) - std::lgamma(0.5 * dof)) / std::sqrt(dof * std::numbers::pi);
  const double density = constant * std::pow(1.0 + x * x / dof, -0.5 * (dof + 1.0));
  return {.value = density, .slope = -(dof + 1.0) * x / (dof + x * x) * density};
}

Density mixture(double x, const LocationDensity& noise) {
  const auto kernel = [&noise](double at) {
    return noise.dof == 0.0 ? normal_density(at) : student_density(at, noise.dof);
  };
  const Density middle = kernel(x);
  const Density left = kernel(x + noise.distance);
  const Density right = kernel(x - noise.distance);
  const auto mix = [&noise](double m, double l, double r) {
    return (1.0 - noise.fraction) * m + 0.5 * noise.fraction * (l + r);
  };
  return {.value = mix(middle.value, left.value, right.value),
          .slope = mix(middle.slope, left.slope, right.slope)};
}

}  // namespace

double location_information(const LocationDensity& noise) {
  if (noise.fraction == 0.0) return noise.dof == 0.0 ? 1.0 : (noise.dof + 1.0) / (noise.dof + 3.0);
  constexpr double step = 0.004;
  const double reach = noise.distance + (noise.dof == 0.0 ? 12.0 : 400.0);
  double sum = 0.0;
  const auto steps = static_cast<std::size_t>(std::ceil(reach / step));
  for (std::size_t k = 0; k < steps; ++k) {
    const double x = (static_cast<double>(k) + 0.5) * step;
    const auto [density, slope] = mixture(x, noise);
    if (density > 0.0) sum += 2.0 * slope * slope / density * step;
  }
  return sum;
}

std::vector<double> efficient_errors(const Dataset& rows, const TermList& terms,
                                     std::span<const double> information) {
  const Matrix bound =
      solve_weighted_least_squares(design_matrix(rows, terms), rows.output, information).unscaled_covariance;
  std::vector<double> errors;
  for (std::size_t k = 0; k < terms.size(); ++k) errors.push_back(std::sqrt(bound(k, k)));
  return errors;
}

}  // namespace proofmass
