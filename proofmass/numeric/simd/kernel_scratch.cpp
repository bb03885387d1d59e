// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/samples.hpp"
#include "proofmass/numeric/simd/kernel_scratch_internal.hpp"

namespace proofmass {

double* kernel_scratch(std::size_t size) {
  thread_local AlignedColumn storage;
  if (storage.size() < size) storage.resize(size);
  return storage.data();
}

}  // namespace proofmass
