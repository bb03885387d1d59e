// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// One power of two per column, which brings the column's Euclidean length into [1/2, 1); 1 for a column of
// zeros. Powers of two, rather than the lengths themselves, make the scaling exact; on NIST Filip its
// rounding would cost digits. Throws std::invalid_argument when the design has an element that is not finite.
[[nodiscard]] std::vector<double> column_scales(const Matrix& design);

}  // namespace proofmass
