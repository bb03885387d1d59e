// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// What of some columns, one value a row each, no combination of the terms of the fit and of the columns
// before gives.
struct ColumnsBeyond {
  Matrix orthonormal;             // rows x those that have something left
  std::vector<std::size_t> kept;  // their places among the columns
};

// A column of which less than `least_left` of its square is left does not count.
[[nodiscard]] ColumnsBeyond columns_beyond(const FittedRows& rows,
                                           std::span<const std::vector<double>> columns, double least_left);

// The probability that the residuals of pure noise follow orthonormal columns beyond the terms, together, as
// far as these do: the larger of that of an F test, and of a Wald test for noise that differs from row to row
// (HC3), or from group to group where `groups` has the rows of each. One where too few degrees of freedom are
// left.
[[nodiscard]] double joint_probability(const FittedRows& rows, const Matrix& columns,
                                       std::span<const std::vector<std::size_t>> groups = {});

}  // namespace proofmass
