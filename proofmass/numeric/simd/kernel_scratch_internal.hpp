// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace proofmass {

// Scratch memory for a kernel's pass over samples, aligned to cache lines. Each thread keeps it for its next
// pass. Its contents are undefined; a second call invalidates the memory of the first.
[[nodiscard]] double* kernel_scratch(std::size_t size);

}  // namespace proofmass
