// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/linear/gram_factor.hpp"

#include <cmath>

#include "proofmass/numeric/linear/rank_analysis.hpp"

namespace proofmass {
namespace {

// The square of a quarter of the tolerance, 2e-28: above the rounding of the sums, and below every column
// that counts as independent.
constexpr double kNoPivot = kRankTolerance * kRankTolerance / 16.0;

// The power of two that brings a length into [1/2, 1), from the square of the length; 1 for zero.
double unit_scale(double square) {
  return square > 0.0 ? std::scalbn(1.0, -(std::ilogb(std::sqrt(square)) + 1)) : 1.0;
}

}  // namespace

GramFactor::GramFactor(const GramMatrix& gram) {
  const std::size_t n = gram.regressors();
  for (std::size_t c = 0; c < n; ++c) scales_.push_back(unit_scale(gram(c, c).value()));
  r_.resize(n * n);
  projection_.resize(n);
  // The Gram matrix after the elimination steps so far, with the products with the response as last column.
  std::vector<DoubleDouble> rest(n * (n + 1));
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      // Multiply by one factor after the other: the product of the factors may overflow.
      rest[j * n + i] = scaled(scaled(gram(i, j), scales_[i]), j < n ? scales_[j] : 1.0);
    }
  }
  std::vector<double> squares;
  for (std::size_t c = 0; c < n; ++c) squares.push_back(rest[c * n + c].value());
  for (std::size_t pivot = 0; pivot < n; ++pivot) {
    if (rest[pivot * n + pivot].value() > kNoPivot * squares[pivot]) eliminate(pivot, rest);
  }
}

void GramFactor::eliminate(std::size_t pivot, std::vector<DoubleDouble>& rest) {
  const std::size_t n = columns();
  const DoubleDouble root = sqrt(rest[pivot * n + pivot]);
  r_[pivot * n + pivot] = root;
  for (std::size_t j = pivot + 1; j < n; ++j) r_[j * n + pivot] = rest[j * n + pivot] / root;
  projection_[pivot] = rest[n * n + pivot] / root;
  for (std::size_t j = pivot + 1; j < n; ++j) {
    for (std::size_t i = pivot + 1; i <= j; ++i) {
      rest[j * n + i] = rest[j * n + i] - r_[i * n + pivot] * r_[j * n + pivot];
    }
    rest[n * n + j] = rest[n * n + j] - r_[j * n + pivot] * projection_[pivot];
  }
}

Matrix GramFactor::rounded() const {
  Matrix result(columns(), columns());
  for (std::size_t j = 0; j < columns(); ++j) {
    for (std::size_t i = 0; i <= j; ++i) result(i, j) = (*this)(i, j).value();
  }
  return result;
}

std::vector<DoubleDouble> GramFactor::inverse() const {
  const std::size_t n = columns();
  std::vector<DoubleDouble> inverse(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    inverse[j * n + j] = DoubleDouble(1.0) / (*this)(j, j);
    for (std::size_t i = j; i-- > 0;) {
      DoubleDouble sum;
      for (std::size_t k = i + 1; k <= j; ++k) sum = sum + (*this)(i, k) * inverse[j * n + k];
      inverse[j * n + i] = -sum / (*this)(i, i);
    }
  }
  return inverse;
}

}  // namespace proofmass
