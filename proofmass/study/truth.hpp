// SPDX-License-Identifier: Apache-2.0
// What is known when a record was simulated: how well its coefficients can be identified at all.
#pragma once

#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/stand/twin/simulation.hpp"
#include "proofmass/study/comparison.hpp"

namespace proofmass {

// Throws a usage Error when plan and record have outputs of different kinds.
void require_same_output(const SimulationPlan& plan, const Dataset& record);

// Variance of each row's output by the plan's noise at the recorded inputs, in the output's canonical unit
// squared: the square of the scale where the noise is not normal. Input noise counts through the model's
// slope, to first order.
[[nodiscard]] std::vector<double> output_variances(const SimulationPlan& plan, const Dataset& record);

// Fisher information about each row's output, one over the output's canonical unit squared, by those
// variances and the shape of the noise. Empty where the plan has no noise, or noise on the inputs together
// with output noise that is not normal.
[[nodiscard]] std::vector<double> row_information(const SimulationPlan& plan, const Dataset& record);

// Fills every contestant's distance from the plan's truth, over standard errors and over the Cramér-Rao
// bound of the terms that it identified, or left out by choice, from its training rows. The bound is for a
// model that holds: what the plan has unmodelled counts as error. Throws a usage Error when plan and record
// have outputs of different kinds.
void score_truth(Comparison& comparison, const Dataset& record, const SimulationPlan& plan);

}  // namespace proofmass
