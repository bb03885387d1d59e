// SPDX-License-Identifier: Apache-2.0
// Sums of products in twice the working precision, by error-free transformations (Ogita, Rump & Oishi,
// "Accurate sum and dot product", SIAM J. Sci. Comput. 26, 2005, algorithm Dot2).
#pragma once

#include <cmath>

namespace proofmass {

// An accumulator whose value is high + low.
struct CompensatedSum {
  double high = 0.0;
  double low = 0.0;

  void add(double value) noexcept {
    const double sum = high + value;
    const double shadow = sum - high;
    low += (high - (sum - shadow)) + (value - shadow);
    high = sum;
  }
  void add_product(double a, double b) noexcept {
    const double product = a * b;
    low += std::fma(a, b, -product);
    add(product);
  }
  [[nodiscard]] double value() const noexcept { return high + low; }
};

}  // namespace proofmass
