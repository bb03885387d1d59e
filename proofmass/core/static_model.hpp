// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "proofmass/core/term.hpp"

namespace proofmass {

// Indicated output E = sum of coefficient * regressor (IEEE Std 1293 model equation). Coefficients are in the
// output's canonical unit per g to the power of the term's order.
struct StaticModel {
  TermList terms;
  std::vector<double> coefficients;  // one a term

  [[nodiscard]] double output(const Acceleration& a) const noexcept;
  // dE/dA along an axis.
  [[nodiscard]] double slope(const Acceleration& a, Axis axis) const noexcept;
  // The variance that standard uncertainties of the inputs, one an axis, give the output, to first order.
  [[nodiscard]] double variance_from_inputs(const Acceleration& a,
                                            const std::array<double, 3>& sigma) const noexcept;
  // The coefficient of a term; 0 when the model does not contain the term.
  [[nodiscard]] double coefficient(Term term) const noexcept;
};

}  // namespace proofmass
