// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/term_sums.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace proofmass {

TermSums::TermSums(const Dataset& data, TermList terms)
    : data_(data),
      terms_(std::move(terms)),
      ranges_(axis_ranges(data)),
      gram_(gram_matrix(TermRows(data, terms_, ranges_))) {}

GramMatrix TermSums::gram(const TermList& some) const {
  std::vector<std::size_t> places;
  for (const Term term : some) {
    const auto at = std::find(terms_.begin(), terms_.end(), term);
    if (at == terms_.end()) throw std::invalid_argument("a term is not among those summed");
    places.push_back(static_cast<std::size_t>(at - terms_.begin()));
  }
  return gram_.select(places);
}

}  // namespace proofmass
