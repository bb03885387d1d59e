// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "proofmass/core/dataset.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// The fraction of the outputs' variance that least squares on the columns of an orthonormal basis leaves,
// with allowance for the number of columns; one where too few rows are left.
[[nodiscard]] double unexplained_by(const Matrix& basis, std::span<const double> output);

// The same of bias, scale factor and cross axes.
[[nodiscard]] double unexplained_by_linear_terms(const Dataset& rows);

// The same without the tenth of the rows that are farthest off.
[[nodiscard]] double unexplained_without_far_rows(const Dataset& rows);

}  // namespace proofmass
