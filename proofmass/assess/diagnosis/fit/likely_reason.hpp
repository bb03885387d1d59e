// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"

namespace proofmass {

// Why a fit does not explain its outputs, a choice by name: "mixed" (inputs of some rows are in another
// unit), "terms" (left out), "rows" (a few are far off); empty where none of these explains them.
// `unexplained`: what of the outputs' variance a reason may leave, at most, to be one.
[[nodiscard]] std::string likely_reason(const FittedRows& rows, double unexplained);

}  // namespace proofmass
