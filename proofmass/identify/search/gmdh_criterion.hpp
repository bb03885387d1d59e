// SPDX-License-Identifier: Apache-2.0
// The external criteria of the group method of data handling, on the rows of a record.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/finding.hpp"
#include "proofmass/core/term.hpp"
#include "proofmass/identify/search/gmdh.hpp"
#include "proofmass/numeric/matrix.hpp"
#include "proofmass/numeric/selection/subset_criterion.hpp"

namespace proofmass {

class GmdhRows {
 public:
  // Divides the training rows at random, by seed and number of rows alone, as the criterion needs. Throws bad
  // data when a part has too few rows for the terms, and a refusal when a part cannot tell them apart.
  GmdhRows(const Dataset& training, const TermList& terms, const Gmdh& options, std::uint64_t seed);

  // Columns of the design should have lengths alike.
  [[nodiscard]] std::unique_ptr<SubsetCriterion> criterion(const Matrix& design,
                                                           std::span<const double> y) const;
  // The rows that a candidate's coefficients come from; empty: all.
  [[nodiscard]] std::span<const std::size_t> fitting() const noexcept;
  // The criterion by its name in the table of options, and the numbers of all rows and of the two parts.
  [[nodiscard]] std::vector<Figure> figures() const;

 private:
  GmdhCriterion kind_;
  std::size_t rows_;
  std::vector<std::size_t> first_, second_;  // fitting and checking, or two halves; none for press
};

}  // namespace proofmass
