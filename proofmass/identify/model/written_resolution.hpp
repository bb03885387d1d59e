// SPDX-License-Identifier: Apache-2.0
// What the rounding of a record's inputs, as it was written, does to the regressors.
#pragma once

#include <optional>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/term.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// Expected sums over the rows of products of the errors that rounding leaves in the regressors, terms x
// terms, in powers of g. To first order an error of an input enters by the regressor's derivative; rounding
// to steps of s is uniform, with variance s² / 12 (JCGM 100:2008, F.2.2.1). Of more than 4096 rows, as many
// evenly spread ones stand for all. Empty when no step is known that is larger than rounding in double
// precision.
[[nodiscard]] std::optional<Matrix> rounding_products(const Dataset& data, const TermList& terms);

}  // namespace proofmass
