// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/random.hpp"

namespace proofmass {

// A network with `inputs` inputs, one hidden layer of `hidden` tanh units and one linear output:
//   output = c + sum_j v_j tanh(w_j . x + b_j).
// Its weights are one vector in the order w_1 … w_H (each `inputs` long), b_1 … b_H, v_1 … v_H, c. The first
// hidden_weights() of them are the hidden layer; the output is linear in the rest.
struct PerceptronShape {
  std::size_t inputs = 3;
  std::size_t hidden = 7;

  [[nodiscard]] constexpr std::size_t hidden_weights() const noexcept { return hidden * (inputs + 1); }
  [[nodiscard]] constexpr std::size_t output_weights() const noexcept { return hidden + 1; }
  [[nodiscard]] constexpr std::size_t parameters() const noexcept {
    return hidden_weights() + output_weights();
  }
};

// Hidden weights for inputs scaled to [-1, 1] after Nguyen & Widrow (1990): magnitude 0.7 * H^(1/inputs) in
// uniformly random directions. Biases are spread evenly over the same magnitude with the sign of each unit's
// first weight, as in MATLAB's initnw. (initnw also doubles weights and biases, because it takes tanh's
// active range as [-2, 2]; docs/bp.md gives the effect here.)
[[nodiscard]] std::vector<double> nguyen_widrow(const PerceptronShape& shape, RandomStream& random);

// Output weights for an initial network: uniform in [-1, 1], including the output bias, as initnw does for a
// linear layer.
[[nodiscard]] std::vector<double> random_output_layer(const PerceptronShape& shape, RandomStream& random);

// The same function in a unique form, independent of sign and order of the hidden units: every output weight
// is positive or zero, and units are in ascending order of their weights.
[[nodiscard]] std::vector<double> canonical_weights(const PerceptronShape& shape,
                                                    std::span<const double> weights);

}  // namespace proofmass
