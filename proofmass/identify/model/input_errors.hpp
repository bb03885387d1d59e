// SPDX-License-Identifier: Apache-2.0
// What the errors of a record's inputs, by the digits they are written in and by their uncertainties, do to
// the regressors.
#pragma once

#include <array>
#include <optional>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/term.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// Standard uncertainty of each axis, in g, from the record's own columns (root mean square over the rows) or,
// where given, from a constant in their place. Zero where neither is known.
[[nodiscard]] std::array<double, 3> input_uncertainties(const Dataset& data, std::optional<double> constant);

// Expected sums over the rows of products of the errors of the regressors, terms x terms, in powers of g, for
// analyse_rank. To first order an error of an input enters by the regressor's derivative. Rounding to steps
// of s is uniform, with variance s² / 12 (JCGM 100:2008, F.2.2.1). Uncertainties count for less than
// rounding, because eiv allows for them: a combination of regressors need only have twice the sum of squares
// that they make, or five standard deviations more than it, which is more where rows are few; and not at all
// in first-order terms, whose standard errors say all. Of more than 4096 rows, as many evenly spread ones
// stand for all. Empty when no error is known that is larger than rounding in double precision.
[[nodiscard]] std::optional<Matrix> input_error_products(const Dataset& data, const TermList& terms,
                                                         const std::array<double, 3>& uncertainties);

}  // namespace proofmass
