// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/model/written_resolution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace proofmass {
namespace {

constexpr std::size_t kMostRows = 4096;
// Steps below this fraction of the axis are those of programs that write all digits they have.
constexpr double kFineStep = 1e-12;

// d regressor / d input, along each axis.
std::array<double, 3> gradient(Term term, const Acceleration& a) {
  if (term == Term::Koq) return {2.0 * std::abs(a.i), 0.0, 0.0};
  const std::array<double, 3> values{a.i, a.o, a.p};
  const auto& powers = info(term).powers;
  std::array<double, 3> slopes{};
  for (std::size_t axis = 0; axis < slopes.size(); ++axis) {
    if (powers[axis] == 0) continue;
    double slope = powers[axis];
    for (std::size_t k = 0; k < values.size(); ++k)
      slope *= std::pow(values[k], powers[k] - (k == axis ? 1 : 0));
    slopes[axis] = slope;
  }
  return slopes;
}

// Variance of the rounding of each axis; zero where the step is not known or is too fine to matter.
std::array<double, 3> rounding_variances(const Dataset& data) {
  std::array<double, 3> variances{};
  for (const Axis axis : data.axes()) {
    const auto k = static_cast<std::size_t>(axis);
    double largest = 0.0;
    for (const double value : data.along(axis)) largest = std::max(largest, std::abs(value));
    const double step = data.acceleration_resolution[k];
    if (step > kFineStep * largest) variances[k] = step * step / 12.0;
  }
  return variances;
}

}  // namespace

std::optional<Matrix> rounding_products(const Dataset& data, const TermList& terms) {
  const std::array<double, 3> variances = rounding_variances(data);
  if (std::all_of(variances.begin(), variances.end(), [](double variance) { return variance == 0.0; }))
    return std::nullopt;
  const std::size_t n = data.rows();
  const std::size_t used = std::min(n, kMostRows);
  const double weight = static_cast<double>(n) / static_cast<double>(std::max<std::size_t>(used, 1));
  Matrix products(terms.size(), terms.size());
  std::vector<std::array<double, 3>> slopes(terms.size());
  for (std::size_t k = 0; k < used; ++k) {
    const Acceleration a = data.at(k * n / used);
    for (std::size_t t = 0; t < terms.size(); ++t) slopes[t] = gradient(terms[t], a);
    for (std::size_t c = 0; c < terms.size(); ++c) {
      for (std::size_t r = 0; r <= c; ++r) {
        double sum = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis)
          sum += variances[axis] * slopes[r][axis] * slopes[c][axis];
        products(r, c) += weight * sum;
      }
    }
  }
  for (std::size_t c = 0; c < terms.size(); ++c) {
    for (std::size_t r = 0; r < c; ++r) products(c, r) = products(r, c);
  }
  return products;
}

}  // namespace proofmass
