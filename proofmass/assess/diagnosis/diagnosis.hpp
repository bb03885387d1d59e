// SPDX-License-Identifier: Apache-2.0
// Faults of a record and of a fit to it (docs/diagnosis.md). Clean records give no warning.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/core/run.hpp"

namespace proofmass {

// What a method does with uncertainties of the inputs.
struct SigmaUse {
  bool inputs_uncertain = false;     // takes the inputs for uncertain at all
  bool input_columns = false;        // goes by the record's columns of them
  std::optional<double> constant{};  // g; of every input, in place of the columns
};

// Of the record alone: units, limits of the output, its counts, repeated rows, time.
[[nodiscard]] std::vector<Finding> diagnose_record(const Dataset& record);

// Of a fit to the record's training rows, scored: coefficients, residuals, uncertainties, test rows. The same
// for every method. `of_record`: what was found in the record, whose consequences are not named again.
[[nodiscard]] std::vector<Finding> diagnose_fit(const Dataset& record, std::span<const Finding> of_record,
                                                const Split& split, const Identification& result,
                                                const SigmaUse& sigmas);

}  // namespace proofmass
