// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dlfcn.h>

#include <string>

namespace bench::peers {

// The processor type for which OpenBLAS chose its kernels; "not OpenBLAS" for another library.
inline std::string blas_kernel() {
  using Name = char* (*)();
  const auto name = reinterpret_cast<Name>(dlsym(RTLD_DEFAULT, "openblas_get_corename"));
  return name != nullptr ? name() : "not OpenBLAS";
}

}  // namespace bench::peers
