// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/model/term_sums.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace proofmass {

TermSums::TermSums(const Dataset& data, TermList terms)
    : data_(data),
      terms_(std::move(terms)),
      ranges_(axis_ranges(data)),
      grams_{.plain = gram_matrix(TermRows(data, terms_, ranges_)), .weighted = {}} {}

TermSums::TermSums(const Dataset& data, TermList terms, std::span<const double> weights)
    : data_(data),
      terms_(std::move(terms)),
      ranges_(axis_ranges(data)),
      grams_(gram_matrices(TermRows(data, terms_, ranges_), weights)) {}

GramMatrix TermSums::gram(const TermList& some) const { return select(grams_.plain, some); }

GramMatrix TermSums::weighted_gram(const TermList& some) const { return select(grams_.weighted, some); }

GramMatrix TermSums::select(const GramMatrix& gram, const TermList& some) const {
  std::vector<std::size_t> places;
  for (const Term term : some) {
    const auto at = std::find(terms_.begin(), terms_.end(), term);
    if (at == terms_.end()) throw std::invalid_argument("a term is not among those summed");
    places.push_back(static_cast<std::size_t>(at - terms_.begin()));
  }
  return gram.select(places);
}

}  // namespace proofmass
