// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/network/perceptron.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace proofmass {

std::vector<double> nguyen_widrow(const PerceptronShape& shape, RandomStream& random) {
  const std::size_t inputs = shape.inputs;
  const auto hidden = static_cast<double>(shape.hidden);
  const double magnitude = 0.7 * std::pow(hidden, 1.0 / static_cast<double>(inputs));
  std::vector<double> weights(shape.hidden_weights());
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    double* const w = weights.data() + j * inputs;
    double square = 0.0;
    for (std::size_t k = 0; k < inputs; ++k) {
      w[k] = random.normal();
      square += w[k] * w[k];
    }
    for (std::size_t k = 0; k < inputs; ++k) w[k] *= magnitude / std::sqrt(square);
    const double spread = shape.hidden > 1 ? -1.0 + 2.0 * static_cast<double>(j) / (hidden - 1.0) : 0.0;
    weights[shape.hidden * inputs + j] = magnitude * spread * (w[0] < 0.0 ? -1.0 : 1.0);
  }
  return weights;
}

std::vector<double> random_output_layer(const PerceptronShape& shape, RandomStream& random) {
  std::vector<double> weights(shape.output_weights());
  for (double& w : weights) w = random.uniform(-1.0, 1.0);
  return weights;
}

std::vector<double> canonical_weights(const PerceptronShape& shape, std::span<const double> weights) {
  struct Unit {
    std::vector<double> w;
    double b, v;
  };
  std::vector<Unit> units(shape.hidden);
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    const auto first = weights.begin() + static_cast<std::ptrdiff_t>(j * shape.inputs);
    Unit& unit = units[j];
    unit.w.assign(first, first + static_cast<std::ptrdiff_t>(shape.inputs));
    unit.b = weights[shape.hidden * shape.inputs + j];
    unit.v = weights[shape.hidden_weights() + j];
    const auto nonzero = [](double w) { return w != 0.0; };
    const auto leading = std::find_if(unit.w.begin(), unit.w.end(), nonzero);
    // A unit with zero output weight takes its sign from its first nonzero weight.
    const double sign = nonzero(unit.v) ? unit.v : leading != unit.w.end() ? *leading : unit.b;
    if (sign < 0.0) {
      for (double& w : unit.w) w = -w;
      unit.b = -unit.b;
      unit.v = -unit.v;
    }
  }
  std::sort(units.begin(), units.end(),
            [](const Unit& a, const Unit& b) { return std::tie(a.w, a.b, a.v) < std::tie(b.w, b.b, b.v); });
  std::vector<double> canonical;
  canonical.reserve(shape.parameters());
  for (const Unit& unit : units) canonical.insert(canonical.end(), unit.w.begin(), unit.w.end());
  for (const Unit& unit : units) canonical.push_back(unit.b);
  for (const Unit& unit : units) canonical.push_back(unit.v);
  canonical.push_back(weights.back());
  return canonical;
}

}  // namespace proofmass
