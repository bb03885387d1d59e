// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// An orthonormal basis of these terms over the rows; of those only that the rows can tell apart.
[[nodiscard]] Matrix orthonormal_rows(const Dataset& rows, const TermList& terms);

// What of the values no combination of the orthonormal columns of a basis gives.
[[nodiscard]] std::vector<double> beyond_columns(const Matrix& basis, std::vector<double> values);

[[nodiscard]] double dot(std::span<const double> a, std::span<const double> b);
[[nodiscard]] double sum_of_squares(std::span<const double> values);

}  // namespace proofmass
