// SPDX-License-Identifier: Apache-2.0
// Who takes part in the paper's experiment, with the budgets asked for.
#pragma once

#include <vector>

#include "proofmass/study/compare.hpp"
#include "proofmass/study/paper/reproduce.hpp"

namespace proofmass {

// One run of plain Levenberg-Marquardt.
[[nodiscard]] Entry textbook_bp(const ReproduceOptions& budget);
// PSO-BP with the paper's preset.
[[nodiscard]] Entry paper_swarm(const ReproduceOptions& budget);
// The same epochs as the paper's swarm spends, on random starts.
[[nodiscard]] Entry multistart(const ReproduceOptions& budget);
// PSO-BP with our default preset.
[[nodiscard]] Entry our_swarm(const ReproduceOptions& budget);
// Those of the paper's Table 2, and ours beside them.
[[nodiscard]] std::vector<Entry> table_2_entries(const ReproduceOptions& budget);

}  // namespace proofmass
