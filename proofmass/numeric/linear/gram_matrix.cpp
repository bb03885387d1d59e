// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/gram_matrix.hpp"

#include <algorithm>
#include <limits>

#include "proofmass/numeric/linear/gram_kernels.hpp"
#include "proofmass/numeric/linear/row_chunks.hpp"

namespace proofmass {
namespace {

GramMatrix sum_of(const std::vector<GramMatrix>& parts, const RegressionRows& rows) {
  GramMatrix sum(rows.scales());
  for (const GramMatrix& part : parts) sum.add(part);
  return sum;
}

}  // namespace

GramMatrix::GramMatrix(std::span<const double> scales)
    : scales_(scales.begin(), scales.end()),
      products_((scales.size() + 1) * (scales.size() + 2) / 2),
      least_(scales.size() + 1, std::numeric_limits<double>::infinity()),
      greatest_(scales.size() + 1, -std::numeric_limits<double>::infinity()) {}

void GramMatrix::widen_range(std::size_t c, double least, double greatest) noexcept {
  least_[c] = std::min(least_[c], least);
  greatest_[c] = std::max(greatest_[c], greatest);
}

GramMatrix GramMatrix::select(std::span<const std::size_t> regressors) const {
  std::vector<double> scales;
  for (const std::size_t c : regressors) scales.push_back(scales_[c]);
  GramMatrix part(scales);
  part.rows_ = rows_;
  const auto source = [&](std::size_t c) { return c < regressors.size() ? regressors[c] : scales_.size(); };
  for (std::size_t j = 0; j <= regressors.size(); ++j) {
    part.widen_range(j, least_[source(j)], greatest_[source(j)]);
    for (std::size_t i = 0; i <= j; ++i) part.products_[place(i, j)] = (*this)(source(i), source(j));
  }
  return part;
}

void GramMatrix::clear(std::size_t regressor) {
  for (std::size_t c = 0; c <= scales_.size(); ++c) {
    products_[c < regressor ? place(c, regressor) : place(regressor, c)] = {};
  }
  least_[regressor] = greatest_[regressor] = 0.0;
}

void GramMatrix::add(const GramMatrix& other) {
  rows_ += other.rows_;
  for (std::size_t k = 0; k < products_.size(); ++k) products_[k] = products_[k] + other.products_[k];
  for (std::size_t c = 0; c < least_.size(); ++c) widen_range(c, other.least_[c], other.greatest_[c]);
}

GramMatrix gram_matrix(const RegressionRows& rows) {
  const std::size_t chunks = row_chunks(rows.rows());
  std::vector<GramMatrix> parts(chunks, GramMatrix(rows.scales()));
  for_each_row_chunk(rows.rows(), [&](std::size_t chunk, std::size_t first, std::size_t last) {
    add_products(rows, first, last, parts[chunk]);
  });
  return sum_of(parts, rows);
}

GramMatrices gram_matrices(const RegressionRows& rows, std::span<const double> weights) {
  require_weights(weights, rows.rows());
  const std::size_t chunks = row_chunks(rows.rows());
  std::vector<GramMatrix> plain(chunks, GramMatrix(rows.scales()));
  std::vector<GramMatrix> weighted = plain;
  for_each_row_chunk(rows.rows(), [&](std::size_t chunk, std::size_t first, std::size_t last) {
    add_products(rows, weights, first, last, plain[chunk], weighted[chunk]);
  });
  return {sum_of(plain, rows), sum_of(weighted, rows)};
}

}  // namespace proofmass
