// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/term.hpp"
#include "proofmass/identify/term_rows.hpp"
#include "proofmass/numeric/gram_matrix.hpp"

namespace proofmass {

// One pass over a record for all that identifiability and least squares on any of the terms need to know of
// its rows. The record must outlive this.
class TermSums {
 public:
  TermSums(const Dataset& data, TermList terms);

  [[nodiscard]] const Dataset& data() const noexcept { return data_; }
  [[nodiscard]] const TermList& terms() const noexcept { return terms_; }
  [[nodiscard]] const AxisRanges& ranges() const noexcept { return ranges_; }
  [[nodiscard]] const GramMatrix& gram() const noexcept { return gram_; }
  // Of some of the terms, in the order named.
  [[nodiscard]] GramMatrix gram(const TermList& some) const;
  // The rows that gram(some) is of.
  [[nodiscard]] TermRows rows(const TermList& some) const { return {data_, some, ranges_}; }

 private:
  const Dataset& data_;
  TermList terms_;
  AxisRanges ranges_;
  GramMatrix gram_;
};

}  // namespace proofmass
