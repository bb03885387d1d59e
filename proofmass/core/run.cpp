// SPDX-License-Identifier: Apache-2.0
#include "proofmass/core/run.hpp"

namespace proofmass {

std::vector<Part> parts_of(const Split& split, std::size_t rows) {
  std::vector<Part> parts(rows, Part::training);
  for (const std::size_t row : split.validation) parts.at(row) = Part::validation;
  for (const std::size_t row : split.test) parts.at(row) = Part::test;
  return parts;
}

}  // namespace proofmass
