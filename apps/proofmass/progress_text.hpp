// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace proofmass::cli {

inline constexpr std::size_t kAnyWidth = std::numeric_limits<std::size_t>::max();

// How far a stage is. The units may be a limit that an iteration ends long before: what is left is told from
// a tenth of them on.
struct StageProgress {
  std::string_view stage;
  std::size_t first = 0;  // units done when the stage was first heard of
  std::size_t done = 0;
  std::size_t total = 0;
  double seconds = 0.0;  // since then
};

// "pso-bp swarm: 12 of 60 (20 %), 1:05 left"; "robust regression: 0:34 so far" of a stage in one piece. A
// line that is to be rewritten must not be broken by the terminal: one of more than `width` columns goes
// without the count, and is cut where that does not do. Stages have names in ASCII.
[[nodiscard]] std::string progress_text(const StageProgress& progress, std::size_t width = kAnyWidth);

}  // namespace proofmass::cli
