// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "proofmass/identify/network/result.hpp"
#include "proofmass/numeric/network/perceptron.hpp"
#include "proofmass/numeric/samples.hpp"

namespace proofmass {

// What least squares with every term that the rows can separate says of the output: the structure that a
// network must have to reach its residual, without the noise.
class LeastSquaresGuide {
 public:
  explicit LeastSquaresGuide(const NetworkTask& task);

  // The training rows, moved outwards a little, with the output of least squares in place of the measured
  // one.
  [[nodiscard]] const Samples& rows() const noexcept { return rows_; }
  // Root mean square difference of a network from least squares, over points close beside the training rows.
  // Scaled output.
  [[nodiscard]] double deviation(const PerceptronShape& shape, std::span<const double> weights) const;
  // Whether that is far beyond the noise and beyond the difference at the rows: a unit fits single rows.
  [[nodiscard]] bool strays(const PerceptronShape& shape, std::span<const double> weights) const;

 private:
  Samples rows_;
  Samples at_rows_;
  Samples beside_;
  double noise_;
};

}  // namespace proofmass
