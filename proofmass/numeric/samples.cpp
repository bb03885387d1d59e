// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/samples.hpp"

#include <algorithm>
#include <cmath>

namespace proofmass {

Samples::Samples(std::size_t inputs, std::size_t rows) : rows_(rows) {
  const std::size_t padded = (rows + kRowMultiple - 1) / kRowMultiple * kRowMultiple;
  inputs_.assign(inputs, AlignedColumn(padded, 0.0));
  target_.assign(padded, 0.0);
  mask_.assign(padded, 0.0);
  std::fill_n(mask_.begin(), rows, 1.0);
}

double root_mean(double sum_of_squares, const Samples& samples) {
  return std::sqrt(sum_of_squares / static_cast<double>(samples.rows()));
}

}  // namespace proofmass
