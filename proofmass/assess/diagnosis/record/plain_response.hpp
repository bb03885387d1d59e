// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "proofmass/core/dataset.hpp"

namespace proofmass {

// The output that most rows have exactly, and how many; of a sample of the rows.
struct CommonOutput {
  double value = 0.0;
  std::size_t count = 0;
};

// What the inputs ask the output to be, as most rows have it: bias, scale factor and cross axes, fitted to
// rows that nothing is suspected of. In the output's canonical unit.
struct PlainResponse {
  std::vector<double> expected;  // one a row of the record
  double scale_factor = 0.0;     // its size, per g
  double scale = 0.0;            // of what the output differs by, in most rows
  double range = 0.0;            // of the record's outputs
  double step = 0.0;             // that they are written in
  CommonOutput common;
  // A change that no noise, rounding or nonlinearity of an accelerometer makes.
  [[nodiscard]] double telling() const;
};

// Nothing where the rows above suspicion determine no scale factor, or hardly more than half of them follow
// it.
[[nodiscard]] std::optional<PlainResponse> plain_response(const Dataset& record);

// From the least to the greatest of the values of these rows.
[[nodiscard]] double spread_over(const std::vector<double>& values, std::span<const std::size_t> rows);

}  // namespace proofmass
