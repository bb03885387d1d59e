// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/identify/search/afsa.hpp"
#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// The coefficients of a linear model in coordinates fit for a search without derivatives: the output that a
// unit of one coordinate makes has the length of the measured output. Works from the triangular factor of the
// design, so that nothing grows with the rows.
class CoefficientSpace {
 public:
  // The design must have full column rank, and y an element other than zero.
  CoefficientSpace(const Matrix& design, std::span<const double> y, FishCoordinates coordinates);

  [[nodiscard]] std::size_t dimensions() const noexcept { return length_.size(); }
  // Root mean square residual at a position, in the unit of y.
  [[nodiscard]] double rmse(std::span<const double> position) const;
  [[nodiscard]] std::vector<double> coefficients(std::span<const double> position) const;

 private:
  Matrix triangle_;              // R of the design
  std::vector<double> rotated_;  // Qᵀy
  std::vector<double> length_;   // of the design's columns
  double output_length_ = 0.0;   // |y|
  double remainder_ = 0.0;       // the part of |y| that no coefficients can explain
  double rows_ = 0.0;
  FishCoordinates coordinates_;
};

}  // namespace proofmass
