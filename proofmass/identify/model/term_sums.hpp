// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/term.hpp"
#include "proofmass/identify/model/term_rows.hpp"
#include "proofmass/numeric/linear/gram_matrix.hpp"

namespace proofmass {

// One pass over a record for all that identifiability and least squares on any of the terms need to know of
// its rows. The record must outlive this.
class TermSums {
 public:
  TermSums(const Dataset& data, TermList terms);
  // And of the rows by weights. Throws std::invalid_argument unless there is one a row, finite and not
  // negative.
  TermSums(const Dataset& data, TermList terms, std::span<const double> weights);

  [[nodiscard]] const Dataset& data() const noexcept { return data_; }
  [[nodiscard]] const TermList& terms() const noexcept { return terms_; }
  [[nodiscard]] const AxisRanges& ranges() const noexcept { return ranges_; }
  [[nodiscard]] const GramMatrix& gram() const noexcept { return grams_.plain; }
  // Of some of the terms, in the order named.
  [[nodiscard]] GramMatrix gram(const TermList& some) const;
  [[nodiscard]] GramMatrix weighted_gram(const TermList& some) const;
  // The rows that gram(some) is of.
  [[nodiscard]] TermRows rows(const TermList& some) const { return {data_, some, ranges_}; }

 private:
  [[nodiscard]] GramMatrix select(const GramMatrix& gram, const TermList& some) const;

  const Dataset& data_;
  TermList terms_;
  AxisRanges ranges_;
  GramMatrices grams_;
};

}  // namespace proofmass
