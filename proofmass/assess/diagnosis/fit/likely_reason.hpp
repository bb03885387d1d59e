// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"

namespace proofmass {

// Why a fit does not explain its outputs, a choice by name: "angles" (inputs are angles of a dividing head),
// "mixed" (inputs of some rows are in another unit), "terms" (left out), "rows" (a few are far off),
// "shifted" (outputs stand beside the inputs of other rows); empty where none of these explains them.
struct Reason {
  std::string name;
  std::size_t shift = 0;  // rows between outputs and inputs
};

// `unexplained`: what of the outputs' variance a reason may leave, at most, to be one.
[[nodiscard]] Reason likely_reason(const FittedRows& rows, double unexplained);

}  // namespace proofmass
