// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "proofmass/assess/diagnosis/fit/fitted_rows.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// Terms that a model lacks.
struct ShortModel {
  Finding finding;
  Matrix columns;  // orthonormal, beyond the terms: what the missing ones add
};

// Whether a method fits the terms asked for: not where it chooses them, or fits what they lack.
[[nodiscard]] bool takes_terms_as_given(const Identification& result);

// Terms of the static model that were not asked for, that the rows can tell apart from those that were, and
// that the residuals follow, one by one or together. Not of methods that choose their terms, or that fit what
// terms lack.
[[nodiscard]] std::optional<ShortModel> find_short_model(const FittedRows& rows,
                                                         const Identification& result);

}  // namespace proofmass
