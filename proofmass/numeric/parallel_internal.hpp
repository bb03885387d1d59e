// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace proofmass {

// oneTBB's loop over 0 … n - 1, each index a task of its own, as body(context, index). The body must not
// throw. Use parallel_for instead.
void run_tbb_tasks(std::size_t n, void (*body)(void*, std::size_t), void* context);

}  // namespace proofmass
