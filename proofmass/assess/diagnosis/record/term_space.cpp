// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/term_space.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "proofmass/identify/model/identifiability.hpp"
#include "proofmass/identify/model/term_sums.hpp"
#include "proofmass/numeric/linear/normal_solution.hpp"

namespace proofmass {

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double sum_of_squares(std::span<const double> values) { return dot(values, values); }

Matrix orthonormal_rows(const Dataset& rows, const TermList& asked) {
  if (rows.rows() == 0) return {};
  const TermSums sums(rows, asked);
  const TermList terms = analyse_identifiability(sums, asked).identified;
  Matrix basis(rows.rows(), terms.size());
  if (terms.empty() || rows.rows() < terms.size()) return Matrix(rows.rows(), 0);
  const TermRows regressors = sums.rows(terms);
  const Matrix orthogonaliser = solve_normal_equations(sums.gram(terms), regressors).orthogonaliser;
  RowBlock block(terms.size() + 1);
  for (std::size_t first = 0; first < rows.rows(); first += RowBlock::kRows) {
    const std::size_t count = std::min(RowBlock::kRows, rows.rows() - first);
    regressors.fill(first, count, block);
    for (std::size_t c = 0; c < terms.size(); ++c) {
      double* const column = basis.column(c).data() + first;
      for (std::size_t k = 0; k <= c; ++k) {
        const double factor = orthogonaliser(k, c);
        const double* const values = block.column(k);
        for (std::size_t r = 0; r < count; ++r) column[r] += factor * values[r];
      }
    }
  }
  return basis;
}

std::vector<double> beyond_columns(const Matrix& basis, std::vector<double> values) {
  for (std::size_t c = 0; c < basis.columns(); ++c) {
    const std::span<const double> column = basis.column(c);
    const double along = dot(column, values);
    for (std::size_t row = 0; row < values.size(); ++row) values[row] -= along * column[row];
  }
  return values;
}

}  // namespace proofmass
