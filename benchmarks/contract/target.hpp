// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <hwy/targets.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string>

namespace bench {

// From here on, run-time dispatch uses this instruction set: sse4, avx2 or avx3.
inline void force_target(const std::string& name) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    std::string known = hwy::TargetName(target);
    std::transform(known.begin(), known.end(), known.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    if (known == name) return hwy::SetSupportedTargetsForTest(target);
  }
  throw std::runtime_error("this processor has no target " + name);
}

}  // namespace bench
