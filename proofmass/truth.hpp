// SPDX-License-Identifier: Apache-2.0
// What is known when a record was simulated: how well its coefficients can be identified at all.
#pragma once

#include <span>
#include <vector>

#include "proofmass/compare.hpp"
#include "proofmass/core/dataset.hpp"
#include "proofmass/stand/simulation.hpp"

namespace proofmass {

// Fisher information about each row's output, one over the output's canonical unit squared, by the plan's
// noise at the recorded inputs. Input noise counts as output noise through the model's slope, to first order.
// Empty where the plan has no noise, or noise on the inputs together with output noise that is not normal.
[[nodiscard]] std::vector<double> row_information(const SimulationPlan& plan, const Dataset& record);

// Fills every contestant's distance from the plan's truth, over standard errors and over the Cramér-Rao
// bound of the terms that it identified from its training rows. The bound is for a model that holds: what
// the plan has unmodelled counts as error. The entries are those that were compared. Throws a usage Error
// when plan and record have outputs of different kinds.
void score_truth(Comparison& comparison, const Dataset& record, std::span<const Entry> entries,
                 const SimulationPlan& plan);

}  // namespace proofmass
