// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/static_model.hpp"

#include <algorithm>

namespace proofmass {

double StaticModel::output(const Acceleration& a) const noexcept {
  double sum = 0.0;
  for (std::size_t k = 0; k < terms.size(); ++k) sum += coefficients[k] * regressor(terms[k], a);
  return sum;
}

double StaticModel::slope(const Acceleration& a, Axis axis) const noexcept {
  double sum = 0.0;
  for (std::size_t k = 0; k < terms.size(); ++k) sum += coefficients[k] * regressor_slope(terms[k], a, axis);
  return sum;
}

double StaticModel::variance_from_inputs(const Acceleration& a,
                                         const std::array<double, 3>& sigma) const noexcept {
  double variance = 0.0;
  for (const Axis axis : kAxes) {
    const double own = sigma[static_cast<std::size_t>(axis)];
    if (own == 0.0) continue;
    const double part = slope(a, axis) * own;
    variance += part * part;
  }
  return variance;
}

double StaticModel::coefficient(Term term) const noexcept {
  const auto found = std::find(terms.begin(), terms.end(), term);
  return found == terms.end() ? 0.0 : coefficients[static_cast<std::size_t>(found - terms.begin())];
}

}  // namespace proofmass
