// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "proofmass/core/term.hpp"
#include "proofmass/numeric/regression/surface.hpp"

namespace proofmass {

// The static model as a surface over the axes given, with the terms' coefficients as parameters. |Ai|*Ai
// counts with its derivative 2|Ai|, which is 0 and continuous at Ai = 0.
class StaticSurface final : public Surface {
 public:
  // Throws std::invalid_argument when a term uses an axis that is not given.
  StaticSurface(const TermList& terms, const std::vector<Axis>& axes);

  [[nodiscard]] std::size_t inputs() const override { return axes_.size(); }
  [[nodiscard]] std::size_t parameters() const override { return factors_.size(); }
  void evaluate(std::span<const double> coefficients, std::size_t rows, SurfaceBlock& block) const override;

 private:
  std::vector<Axis> axes_;
  // Of each term and each axis: the power, or kSignedSquare.
  std::vector<std::vector<std::size_t>> factors_;
};

}  // namespace proofmass
