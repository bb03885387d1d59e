// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

namespace bench {

// tanh as the product's kernels compute it; false when the library does not export it.
bool product_tanh(std::span<const double> z, std::span<double> result);

}  // namespace bench
