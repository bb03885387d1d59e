// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace proofmass {

// Working storage of a kernel's pass over samples, aligned to cache lines, kept by each thread for its next
// pass. What it holds is undefined; a second call takes back what the first gave.
[[nodiscard]] double* kernel_scratch(std::size_t size);

}  // namespace proofmass
