// SPDX-License-Identifier: Apache-2.0
// Predictions and curves as CSV. Numbers are the shortest that read back to the same bits.
#pragma once

#include <iosfwd>
#include <span>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/run.hpp"

namespace proofmass {

// What a fit predicts for the rows of the record it came from. Columns: `line` of the record's file, `part`
// (train, validation or test), the record's inputs in g, `E`, `E_predicted` and `residual` in the output's
// declared unit. `predicted` (canonical unit) and `parts` have one entry a row, else std::invalid_argument.
void write_predictions(std::ostream& out, const Dataset& record, std::span<const double> predicted,
                       std::span<const Part> parts);

// The same for rows whose output is not known: the inputs in g and `E_predicted` in `output`'s declared unit.
void write_forecast(std::ostream& out, const Dataset& inputs, std::span<const double> predicted,
                    const Unit& output);

// Training curves and the swarm's convergence: columns `curve`, `iteration` (from 0) and `value`.
void write_history(std::ostream& out, std::span<const Curve> curves);

}  // namespace proofmass
