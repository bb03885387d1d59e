// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/numeric/matrix.hpp"

namespace proofmass {

// Points of a surface with their values and derivatives, stored by column so that loops run over rows.
struct SurfaceBlock {
  static constexpr std::size_t kRows = 256;
  SurfaceBlock(std::size_t inputs, std::size_t parameters)
      : x(kRows, inputs), value(kRows), by_input(kRows, inputs), by_parameter(kRows, parameters) {}

  Matrix x;                   // kRows x inputs: the points
  std::vector<double> value;  // kRows
  Matrix by_input;            // kRows x inputs: derivatives of the value
  Matrix by_parameter;        // kRows x parameters
};

// A differentiable function of a few inputs and of parameters.
class Surface {
 public:
  Surface() = default;
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;
  virtual ~Surface() = default;

  [[nodiscard]] virtual std::size_t inputs() const = 0;
  [[nodiscard]] virtual std::size_t parameters() const = 0;
  // Fills value and derivatives of the first `rows` rows from their x. Called from several threads at once.
  virtual void evaluate(std::span<const double> parameters, std::size_t rows, SurfaceBlock& block) const = 0;
};

}  // namespace proofmass
