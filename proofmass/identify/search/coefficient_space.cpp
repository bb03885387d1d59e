// SPDX-License-Identifier: Apache-2.0
#include "proofmass/identify/search/coefficient_space.hpp"

#include <algorithm>
#include <cmath>

#include "proofmass/numeric/linear/triangular_accumulator.hpp"

namespace proofmass {
namespace {

double squared(double x) { return x * x; }

Matrix with_output(const Matrix& design, std::span<const double> y) {
  Matrix all(design.rows(), design.columns() + 1);
  for (std::size_t c = 0; c < design.columns(); ++c) {
    std::copy(design.column(c).begin(), design.column(c).end(), all.column(c).begin());
  }
  std::copy(y.begin(), y.end(), all.column(design.columns()).begin());
  return all;
}

}  // namespace

CoefficientSpace::CoefficientSpace(const Matrix& design, std::span<const double> y,
                                   FishCoordinates coordinates)
    : rows_(static_cast<double>(design.rows())), coordinates_(coordinates) {
  const std::size_t n = design.columns();
  TriangularAccumulator accumulator(n + 1);
  accumulator.add(with_output(design, y), design.rows());
  triangle_ = accumulator.r();
  rotated_.assign(triangle_.column(n).begin(), triangle_.column(n).begin() + static_cast<std::ptrdiff_t>(n));
  remainder_ = triangle_(n, n);
  const auto length = [this](std::size_t c) {
    double sum = 0.0;
    for (std::size_t r = 0; r <= c; ++r) sum += squared(triangle_(r, c));
    return std::sqrt(sum);
  };
  for (std::size_t c = 0; c < n; ++c) length_.push_back(length(c));
  output_length_ = length(n);
}

double CoefficientSpace::rmse(std::span<const double> position) const {
  double sum = squared(remainder_);
  for (std::size_t r = 0; r < dimensions(); ++r) {
    double fitted = position[r];
    if (coordinates_ == FishCoordinates::columns) {
      fitted = 0.0;
      for (std::size_t c = r; c < dimensions(); ++c) fitted += triangle_(r, c) / length_[c] * position[c];
    }
    sum += squared(rotated_[r] - output_length_ * fitted);
  }
  return std::sqrt(sum / rows_);
}

std::vector<double> CoefficientSpace::coefficients(std::span<const double> position) const {
  std::vector<double> result(dimensions());
  for (std::size_t r = dimensions(); r-- > 0;) {
    if (coordinates_ == FishCoordinates::columns) {
      result[r] = output_length_ * position[r] / length_[r];
      continue;
    }
    double rest = output_length_ * position[r];
    for (std::size_t c = r + 1; c < dimensions(); ++c) rest -= triangle_(r, c) * result[c];
    result[r] = rest / triangle_(r, r);
  }
  return result;
}

}  // namespace proofmass
