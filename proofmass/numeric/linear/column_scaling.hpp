// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// One power of two a column that brings the column's Euclidean length into [1/2, 1); 1 for a column of zeros.
// Powers of two, not the lengths themselves, so that scaling rounds nothing: on NIST Filip the rounding would
// cost digits. Throws std::invalid_argument when the design has an element that is not finite.
[[nodiscard]] std::vector<double> column_scales(const Matrix& design);

}  // namespace proofmass
