// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/stand/twin/simulation.hpp"

namespace proofmass {

// What makes it doubtful that the record was simulated by the plan, a finding each; empty when nothing does.
// `named` is the plan that the record names itself (plan_named_in), or empty. Looked at are that name,
// accelerations that the plan cannot have, and outputs that lie farther from the plan's or nearer to them
// than its noise explains, by the median over the rows. Throws a usage Error when plan and record have
// outputs of different kinds.
[[nodiscard]] std::vector<Finding> doubts_about_truth(const SimulationPlan& plan, const Dataset& record,
                                                      const std::string& named);

}  // namespace proofmass
