// SPDX-License-Identifier: Apache-2.0
#include "limits/tanh.hpp"

namespace bench {

bool product_tanh(std::span<const double>, std::span<double>) { return false; }

}  // namespace bench
