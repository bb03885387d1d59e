// SPDX-License-Identifier: Apache-2.0
// Work that keeps one kind of execution port busy, by instruction set.
#pragma once

#include <cstddef>

namespace bench {

inline constexpr std::size_t kLoadDoubles = 2048;  // 16 KiB
inline constexpr std::size_t kLoadRepeats = 32;

// For the instruction set that dispatch chooses. The return values depend on all the work.
struct Kernels {
  const char* target;
  std::size_t lanes;
  std::size_t operations;  // vectors processed by fma … permute
  double (*fma)();
  double (*add)();
  double (*min)();
  double (*divide)();
  double (*permute)();
  double (*load)(const double* data);  // kLoadRepeats passes over kLoadDoubles
  void (*highway_tanh)(const double* z, std::size_t n, double* result);
};

[[nodiscard]] Kernels kernels();

}  // namespace bench
