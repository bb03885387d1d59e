// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"

namespace proofmass {

// How finely a record's output is written, in its canonical unit.
struct OutputResolution {
  double step = 0.0;      // of the decimals or the grid; zero where a sample of the rows shows none
  double decimals = 0.0;  // the step of the decimals alone
  double range = 0.0;     // from the smallest to the largest output
};

// Of a record with rows.
[[nodiscard]] OutputResolution output_resolution(const Dataset& record);

}  // namespace proofmass
