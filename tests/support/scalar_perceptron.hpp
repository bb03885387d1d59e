// SPDX-License-Identifier: Apache-2.0
// A straightforward perceptron, one sample at a time in extended precision. The kernels must agree with it.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/network/perceptron.hpp"
#include "proofmass/numeric/random.hpp"
#include "proofmass/numeric/samples.hpp"

namespace proofmass::test {

using Real = long double;
using RealVector = std::vector<Real>;

// One sample's inputs.
inline RealVector sample_inputs(const Samples& samples, std::size_t row) {
  RealVector x;
  for (std::size_t k = 0; k < samples.inputs(); ++k) x.push_back(samples.input_data(k)[row]);
  return x;
}

// The weights may be more than the hidden layer needs; only the first ones are read.
template <typename Weights>
Real scalar_activation(const PerceptronShape& shape, const Weights& weights, std::size_t unit,
                       const RealVector& x) {
  Real z = weights[shape.hidden * shape.inputs + unit];
  for (std::size_t k = 0; k < shape.inputs; ++k) z += Real{weights[unit * shape.inputs + k]} * x[k];
  return std::tanh(z);
}

template <typename Weights>
Real scalar_output(const PerceptronShape& shape, const Weights& weights, const RealVector& x) {
  Real output = weights[shape.parameters() - 1];
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    output += Real{weights[shape.hidden_weights() + j]} * scalar_activation(shape, weights, j, x);
  }
  return output;
}

// Derivatives of v . tanh(w x + b) by the hidden weights.
inline RealVector scalar_hidden_gradient(const PerceptronShape& shape, std::span<const double> hidden_weights,
                                         std::span<const double> v, const RealVector& x) {
  RealVector gradient(shape.hidden_weights());
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    const Real h = scalar_activation(shape, hidden_weights, j, x);
    const Real slope = v[j] * (1 - h * h);
    for (std::size_t k = 0; k < shape.inputs; ++k) gradient[j * shape.inputs + k] = slope * x[k];
    gradient[shape.hidden * shape.inputs + j] = slope;
  }
  return gradient;
}

// Derivatives of the output by all weights.
inline RealVector scalar_gradient(const PerceptronShape& shape, std::span<const double> weights,
                                  const RealVector& x) {
  RealVector gradient =
      scalar_hidden_gradient(shape, weights, weights.subspan(shape.hidden_weights(), shape.hidden), x);
  for (std::size_t j = 0; j < shape.hidden; ++j) {
    gradient.push_back(scalar_activation(shape, weights, j, x));
  }
  gradient.push_back(1);
  return gradient;
}

// Inputs uniform in [-1, 1], target standard normal.
inline Samples random_samples(std::size_t inputs, std::size_t rows, RandomStream& random) {
  Samples samples(inputs, rows);
  for (std::size_t k = 0; k < inputs; ++k) {
    for (double& x : samples.input(k)) x = random.uniform(-1.0, 1.0);
  }
  for (double& y : samples.target()) y = random.normal();
  return samples;
}

inline std::vector<double> random_vector(std::size_t n, RandomStream& random) {
  std::vector<double> values(n);
  for (double& value : values) value = random.normal();
  return values;
}

}  // namespace proofmass::test
