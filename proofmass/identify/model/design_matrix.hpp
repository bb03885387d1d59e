// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/term.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// One column a term, one row a row of the record: the regressors of the static model equation, in powers of
// g.
[[nodiscard]] Matrix design_matrix(const Dataset& data, const TermList& terms);

}  // namespace proofmass
