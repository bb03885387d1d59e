// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/regression_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "proofmass/numeric/linear/column_scaling.hpp"

namespace proofmass {

MatrixRows::MatrixRows(const Matrix& design, std::span<const double> y)
    : design_(design), y_(y), scales_(column_scales(design)) {
  if (y.size() != design.rows()) throw std::invalid_argument("a regression needs one y a row");
  if (!std::all_of(y.begin(), y.end(), [](double value) { return std::isfinite(value); })) {
    throw std::invalid_argument("the right-hand side has an element that is not finite");
  }
}

void MatrixRows::fill(std::size_t first, std::size_t count, RowBlock& block) const {
  for (std::size_t c = 0; c < design_.columns(); ++c) {
    const auto part = design_.column(c).subspan(first, count);
    std::transform(part.begin(), part.end(), block.column(c),
                   [scale = scales_[c]](double value) { return scale * value; });
  }
  std::copy_n(y_.data() + first, count, block.column(design_.columns()));
}

void require_weights(std::span<const double> weights, std::size_t rows) {
  if (weights.size() != rows) throw std::invalid_argument("weighted rows need one weight each");
  for (const double weight : weights) {
    if (!(weight >= 0.0) || !std::isfinite(weight)) {
      throw std::invalid_argument("a weight must be finite and not negative");
    }
  }
}

WeightedRows::WeightedRows(const RegressionRows& rows, std::vector<double> weights)
    : rows_(rows), weights_(std::move(weights)) {
  require_weights(weights_, rows.rows());
}

void WeightedRows::fill(std::size_t first, std::size_t count, RowBlock& block) const {
  rows_.fill(first, count, block);
  std::array<double, RowBlock::kRows> factors;
  for (std::size_t r = 0; r < count; ++r) factors[r] = std::sqrt(weights_[first + r]);
  for (std::size_t c = 0; c < block.columns(); ++c) {
    double* const column = block.column(c);
    for (std::size_t r = 0; r < count; ++r) column[r] *= factors[r];
  }
}

}  // namespace proofmass
