// SPDX-License-Identifier: Apache-2.0
#include "limits/tanh.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"

namespace bench {

bool product_tanh(std::span<const double> z, std::span<double> result) {
  proofmass::tanh_of(z, result);
  return true;
}

}  // namespace bench
