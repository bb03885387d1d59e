// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/model/design_matrix.hpp"

namespace proofmass {

Matrix design_matrix(const Dataset& data, const TermList& terms) {
  Matrix design(data.rows(), terms.size());
  for (std::size_t c = 0; c < terms.size(); ++c) {
    const auto column = design.column(c);
    for (std::size_t r = 0; r < column.size(); ++r) column[r] = regressor(terms[c], data.at(r));
  }
  return design;
}

}  // namespace proofmass
