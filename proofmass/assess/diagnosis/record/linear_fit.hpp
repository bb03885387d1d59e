// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/static_model.hpp"

namespace proofmass {

// How closely a record's output follows its inputs, before any identification.
struct LinearFit {
  StaticModel model;          // bias, scale factor and cross axes, those that the rows determine
  double scale_factor = 0.0;  // Ki, in the output's canonical unit per g; zero where the rows determine none
  double cross_axes = 0.0;    // the larger of |Ko| and |Kp|
  std::vector<double> residuals;  // one a row, in the output's canonical unit
  double scale = 0.0;             // of them, by their median: outlying rows move it little
  double rss = 0.0;
};

// Least squares with bias, scale factor and cross axes, as far as the rows determine them. Of a record that
// determines none, or without rows, the residuals are the outputs.
[[nodiscard]] LinearFit fit_linear(const Dataset& rows);

}  // namespace proofmass
