// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/column_scaling.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

namespace proofmass {
namespace {

// The exponent e with length = m * 2^e, m in [1/2, 1), computed without overflow; 0 for a length of zero.
int length_exponent(std::span<const double> column) {
  double largest = 0.0;
  bool finite = true;
  for (const double value : column) {
    finite = finite && std::isfinite(value);
    largest = std::max(largest, std::abs(value));
  }
  if (!finite) throw std::invalid_argument("the design matrix has an element that is not finite");
  if (largest == 0.0) return 0;
  const int first = std::ilogb(largest);
  double sum = 0.0;
  for (const double value : column) {
    const double scaled = std::scalbn(value, -first);
    sum += scaled * scaled;
  }
  return first + std::ilogb(std::sqrt(sum)) + 1;
}

}  // namespace

std::vector<double> column_scales(const Matrix& design) {
  std::vector<double> scales(design.columns(), 1.0);
  for (std::size_t c = 0; c < design.columns(); ++c) {
    scales[c] = std::scalbn(1.0, -length_exponent(design.column(c)));
  }
  return scales;
}

}  // namespace proofmass
